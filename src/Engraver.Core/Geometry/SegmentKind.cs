namespace Engraver.Core.Geometry;

/// <summary>What a segment is; the numbers are slot 0 of the entity table (paper 001, Table 2: "1 is line, 2 is circle, 3 is arc").</summary>
/// <remarks>4 and 5 extend the paper: slots 1 to 6 hold their ends, the curve itself stands in a side column.</remarks>
public enum SegmentKind : byte
{
    Line = 1,
    Circle = 2,
    Arc = 3,

    /// <summary>An ellipse or elliptical arc, however it came about (drawn, a circle tilted or in an unequally scaled block).</summary>
    Ellipse = 4,
    Spline = 5,
}
