namespace Engraver.Core.Geometry;

/// <summary>The kind of a segment; the numbers are slot 0 of the entity table (paper 001, Table 2: "1 is line, 2 is circle, 3 is arc").</summary>
/// <remarks>4 and 5 extend the paper: slots 1 to 6 hold the ends, and a side column holds the curve itself.</remarks>
public enum SegmentKind : byte
{
    Line = 1,
    Circle = 2,
    Arc = 3,

    /// <summary>An ellipse or elliptical arc, whether drawn as one or made from a circle by tilting or unequal scaling.</summary>
    Ellipse = 4,
    Spline = 5,
}
