using Engraver.Core.Geometry;
using FsCheck;
using FsCheck.Fluent;

namespace Engraver.TestKit;

/// <summary>Arcs for properties: every quadrant, both directions, radii from a micrometre to ten metres, and quadrant angles more often than by
/// chance.</summary>
public static class Arcs
{
    private static readonly Gen<double> Coordinate = Gen.Choose(-1_000_000, 1_000_000).Select(micrometres => micrometres / 1000.0);

    private static readonly Gen<double> Radius = Gen.Choose(-3, 3).SelectMany(decade => Gen.Choose(1_000, 9_999).Select(digits => digits / 1000.0 * Math.Pow(10.0, decade)));

    private static readonly Gen<double> StartDegrees = Gen.Frequency(
        (3, Gen.Choose(0, 359_999).Select(thousandths => thousandths / 1000.0)),
        (1, Gen.Choose(0, 3).Select(quadrant => 90.0 * quadrant)));

    private static readonly Gen<double> SweepDegrees = Gen.Choose(1, 359_999).SelectMany(
        thousandths => Gen.Elements(1.0, -1.0).Select(sign => sign * thousandths / 1000.0));

    private static readonly Gen<ArcSegment> Arc =
        from x in Coordinate
        from y in Coordinate
        from radius in Radius
        from start in StartDegrees
        from sweep in SweepDegrees
        select new ArcSegment(new Point2D(x, y), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep));

    /// <summary>Either direction, never a whole turn.</summary>
    public static Arbitrary<ArcSegment> Any { get; } = Arc.ToArbitrary();

    /// <summary>As DXF writes arcs: counter-clockwise.</summary>
    public static Arbitrary<ArcSegment> CounterClockwise { get; } = Arc.Select(arc => arc with { Sweep = arc.Sweep.Abs() }).ToArbitrary();
}
