using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Allowed differences between a toolpath and its drawing, millimetres.</summary>
/// <param name="MaxError">Largest distance of arcs and lines from the ellipse or spline that they approximate, of a recovered arc from its lines, and of a
/// duplicate from the moves that replace it.</param>
/// <param name="JoinTolerance">Largest gap between two moves of a stroke.</param>
/// <param name="ArcsRecovered">True when arcs may replace lines.</param>
public sealed record ToolpathTolerances(double MaxError, double JoinTolerance, bool ArcsRecovered)
{
    /// <summary>Rounding error as a part of the numbers from which a point is computed.</summary>
    private const double Rounding = 4e-15;

    /// <summary>Finest tolerance of an arc fit, as a part of the curve's size and of its coordinates (docs/pipeline.md).</summary>
    private const double FinestOfSize = 1e-9;

    private const double FinestOfPlace = 1e-13;

    /// <summary>Largest distance of a move from the drawn segment that it replaces, mm.</summary>
    public double For(in Segment drawn)
    {
        var box = drawn.Bounds;
        var place = Math.Max(Math.Max(Math.Abs(box.MinX), Math.Abs(box.MaxX)), Math.Max(Math.Abs(box.MinY), Math.Abs(box.MaxY)));
        return (1.000001 * Math.Max(MaxError, Math.Max(FinestOfSize * (box.Width + box.Height), FinestOfPlace * place))) + RoundingOf(drawn);
    }

    /// <summary>Rounding error of the segment's points, mm; for an arc, a distant centre can enlarge it.</summary>
    public static double RoundingOf(in Segment segment) => segment.Kind is SegmentKind.Arc or SegmentKind.Circle
        ? Rounding * (segment.Arc.Radius + Math.Abs(segment.Arc.Centre.X) + Math.Abs(segment.Arc.Centre.Y))
        : Rounding * (Math.Abs(segment.Start.X) + Math.Abs(segment.Start.Y));
}
