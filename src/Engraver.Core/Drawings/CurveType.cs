namespace Engraver.Core.Drawings;

/// <summary>The DXF type as which a curve was written; an arc in a block remains an Arc here, even if the block's scale makes an ellipse of it.</summary>
public enum CurveType : byte
{
    Line,
    Arc,
    Circle,
    Ellipse,
    Spline,
    LwPolyline,
    Polyline,

    /// <summary>A loop of a hatch boundary (this and the following only when the operator chooses to cut them).</summary>
    Hatch,
    MLine,
    Leader,
    Helix,
    Solid,
    Trace,
    Face3D,

    /// <summary>The letters of a TEXT or constant ATTDEF (this and the following only when texts are cut).</summary>
    Text,

    /// <summary>The letters of an MTEXT.</summary>
    MText,

    /// <summary>The letters of an attribute of an insert.</summary>
    Attribute,

    /// <summary>A POINT that is drilled (this and the following without parts, and only in the drawing of a job).</summary>
    Point,

    /// <summary>An INSERT without curves at whose insertion point is drilled.</summary>
    Insert,
}
