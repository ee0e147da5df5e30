namespace Engraver.App.Canvas.Marks;

/// <summary>Marks that keep their size on the screen at every zoom. Each kind has its own shape, so that colour alone never carries the meaning.</summary>
internal enum MarkKind : byte
{
    /// <summary>A number beside an arrow in the direction of travel.</summary>
    Order,

    /// <summary>A small ring.</summary>
    Start,

    /// <summary>A ring with a cross inside.</summary>
    Finding,

    /// <summary>A ring with a long upright cross: the work origin.</summary>
    Origin,

    /// <summary>A diagonal cross: a POINT of the drawing, as AutoCAD shows it with PDMODE 3.</summary>
    Point,
}
