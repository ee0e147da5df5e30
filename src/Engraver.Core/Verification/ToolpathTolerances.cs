using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>What a toolpath may differ by from its drawing, millimetres.</summary>
/// <param name="MaxError">How far arcs and lines may lie from the ellipse or spline that they stand for, a recovered arc from its lines, and a duplicate from what is cut in its place.</param>
/// <param name="JoinTolerance">How wide a gap a stroke may run across.</param>
/// <param name="ArcsRecovered">True when arcs may stand for lines.</param>
public sealed record ToolpathTolerances(double MaxError, double JoinTolerance, bool ArcsRecovered)
{
    /// <summary>Of the numbers that a place is computed from.</summary>
    private const double Rounding = 4e-15;

    /// <summary>No arc can follow a curve more finely than this part of its size, nor than this part of its coordinates (docs/pipeline.md).</summary>
    private const double FinestOfSize = 1e-9;

    private const double FinestOfPlace = 1e-13;

    /// <summary>How far from a drawn segment a move that stands for it may lie.</summary>
    public double For(in Segment drawn)
    {
        var box = drawn.Bounds;
        var place = Math.Max(Math.Max(Math.Abs(box.MinX), Math.Abs(box.MaxX)), Math.Max(Math.Abs(box.MinY), Math.Abs(box.MaxY)));
        return (1.000001 * Math.Max(MaxError, Math.Max(FinestOfSize * (box.Width + box.Height), FinestOfPlace * place))) + RoundingOf(drawn);
    }

    /// <summary>By how much the places of an arc are off because its centre is far away; a line's are exact.</summary>
    public static double RoundingOf(in Segment segment) => segment.Kind is SegmentKind.Arc or SegmentKind.Circle
        ? Rounding * (segment.Arc.Radius + Math.Abs(segment.Arc.Centre.X) + Math.Abs(segment.Arc.Centre.Y))
        : Rounding * (Math.Abs(segment.Start.X) + Math.Abs(segment.Start.Y));
}
