namespace Engraver.App.Canvas.Picking;

/// <summary>Object snaps; the numbers are those of AutoCAD's OSMODE.</summary>
[Flags]
public enum SnapKinds
{
    None = 0,
    End = 1,
    Middle = 2,
    Centre = 4,

    /// <summary>A POINT.</summary>
    Node = 8,
    Quadrant = 16,
    Intersection = 32,

    /// <summary>The foot of the perpendicular from the previous point.</summary>
    Perpendicular = 128,

    /// <summary>The tangent point of a line from the previous point.</summary>
    Tangent = 256,

    /// <summary>Any point of an object.</summary>
    Nearest = 512,
    All = End | Middle | Centre | Quadrant | Intersection,
}
