namespace Engraver.Fonts.StrokeFiles;

/// <summary>The special codes of a shape (AutoCAD Customization Guide, "Special codes reference"). Every other code is a vector.</summary>
internal enum ShxCode : byte
{
    End = 0,
    PenDown = 1,
    PenUp = 2,
    Divide = 3,
    Multiply = 4,
    Push = 5,
    Pop = 6,
    Subshape = 7,
    Displacement = 8,
    Displacements = 9,
    OctantArc = 10,
    FractionalArc = 11,
    BulgeArc = 12,
    BulgeArcs = 13,
    VerticalOnly = 14,
}
