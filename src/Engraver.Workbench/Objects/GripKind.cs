namespace Engraver.Workbench.Objects;

/// <summary>Effect of dragging a grip.</summary>
public enum GripKind
{
    /// <summary>Moves an end or a vertex; arcs that meet there keep their included angle.</summary>
    Vertex,

    /// <summary>Moves the whole object.</summary>
    Whole,

    /// <summary>Moves a side of a polyline, both its vertices.</summary>
    Side,

    /// <summary>Bends an arc between its ends, so that it passes through the point.</summary>
    Bulge,

    /// <summary>Changes the radius of a circle.</summary>
    Radius,

    /// <summary>Changes the length of an axis of an ellipse.</summary>
    Axis,
}
