using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Geometry.Constructions;

public class ArcConstructionTests
{
    /// <summary>Relative tolerance, by the arc's size and position, for the given values.</summary>
    private const double Near = 1e-9;

    [Fact]
    public void The_unit_circle_in_every_way()
    {
        var (east, north, west) = (new Point2D(1, 0), new Point2D(0, 1), new Point2D(-1, 0));

        Same(ArcConstruction.ThroughPoints(east, north, west), 0, 0, 1, 0, 180);
        Same(ArcConstruction.ThroughPoints(west, north, east), 0, 0, 1, 180, -180);
        Same(ArcConstruction.FromCentreTo(north, default, new Point2D(7, 0)), 0, 0, 1, 90, 270);
        Same(ArcConstruction.FromCentreSweep(east, default, Angle.FromDegrees(-90)), 0, 0, 1, 0, -90);
        Same(ArcConstruction.FromCentreChord(east, default, Math.Sqrt(2)), 0, 0, 1, 0, 90);
        Same(ArcConstruction.FromCentreChord(east, default, -Math.Sqrt(2)), 0, 0, 1, 0, 270);
        Same(ArcConstruction.FromCentreChord(east, default, 2), 0, 0, 1, 0, 180);
        Same(ArcConstruction.FromEndsSweep(east, north, Angle.FromDegrees(90)), 0, 0, 1, 0, 90);
        Same(ArcConstruction.FromEndsRadius(east, north, 1), 0, 0, 1, 0, 90);
        Same(ArcConstruction.FromEndsRadius(north, east, -1), 0, 0, 1, 90, 270);
        Same(ArcConstruction.FromEndsRadius(east, west, 1), 0, 0, 1, 0, 180);
        Same(ArcConstruction.FromEndsDirection(east, north, new Vector2D(0, 3)), 0, 0, 1, 0, 90);
        Same(ArcConstruction.FromEndsDirection(east, west, new Vector2D(0, -1)), 0, 0, 1, 0, -180);
    }

    [Fact]
    public void What_makes_no_arc_gives_none()
    {
        var (a, b, c) = (new Point2D(0, 0), new Point2D(1, 1), new Point2D(3, 3));

        Assert.Null(ArcConstruction.ThroughPoints(a, b, c));
        Assert.Null(ArcConstruction.ThroughPoints(a, b, a));
        Assert.Null(ArcConstruction.ThroughPoints(a, a, b));
        Assert.Null(ArcConstruction.FromCentreTo(a, b, b));
        Assert.Null(ArcConstruction.FromCentreTo(a, b, new Point2D(-1, -1)));
        Assert.Null(ArcConstruction.FromCentreTo(a, a, b));
        Assert.Null(ArcConstruction.FromCentreSweep(a, b, Angle.FullTurn));
        Assert.Null(ArcConstruction.FromCentreChord(a, b, 3));
        Assert.Null(ArcConstruction.FromEndsSweep(a, a, Angle.FromDegrees(90)));
        Assert.Null(ArcConstruction.FromEndsSweep(a, b, Angle.Zero));
        Assert.Null(ArcConstruction.FromEndsRadius(a, b, 0.7));
        Assert.Null(ArcConstruction.FromEndsDirection(a, b, new Vector2D(2, 2)));
        Assert.Null(ArcConstruction.FromEndsDirection(a, b, new Vector2D(-2, -2)));
        Assert.Null(ArcConstruction.FromEndsDirection(a, b, default));
    }

    [Property]
    public Property Three_points_of_any_arc_are_on_the_arc_through_them_in_their_order() =>
        Prop.ForAll(Arcs.Any, Part(), (arc, part) =>
        {
            var (start, second, end) = (arc.StartPoint, arc.PointAt(part), arc.EndPoint);
            if (ArcConstruction.ThroughPoints(start, second, end) is not { } made) return Math.Abs(arc.Sweep.Degrees) < 0.01 || Math.Abs(arc.Sweep.Degrees) > 359.99 || arc.Radius < 0.01;
            var size = made.Radius + Math.Abs(start.X) + Math.Abs(start.Y);
            return made.StartPoint.IsNear(start, Near * size) && made.EndPoint.IsNear(end, Near * size) && made.DistanceTo(second) <= Near * size;
        });

    [Property]
    public Property An_arc_of_ends_and_an_angle_or_a_direction_is_the_arc_they_were_taken_from() =>
        Prop.ForAll(Arcs.Any, arc =>
        {
            if (Math.Abs(arc.Sweep.Degrees) is < 1.0 or > 350.0) return true;
            var size = arc.Radius + Math.Abs(arc.Centre.X) + Math.Abs(arc.Centre.Y);
            return IsNear(ArcConstruction.FromEndsSweep(arc.StartPoint, arc.EndPoint, arc.Sweep), arc, 1e-8 * size / arc.Radius)
                && IsNear(ArcConstruction.FromEndsDirection(arc.StartPoint, arc.EndPoint, arc.TangentAt(0.0) * 5.0), arc, 1e-8 * size / arc.Radius)
                && IsNear(ArcConstruction.FromCentreSweep(arc.StartPoint, arc.Centre, arc.Sweep), arc, 1e-8 * size / arc.Radius);
        });

    [Property]
    public Property An_arc_about_a_centre_begins_where_it_is_told_and_its_chord_is_as_long_as_told() =>
        Prop.ForAll(Arcs.CounterClockwise, Part(), (arc, part) =>
        {
            var start = arc.StartPoint;
            var radius = start.DistanceTo(arc.Centre);
            var chord = 2.0 * radius * part;
            var (shorter, longer) = (ArcConstruction.FromCentreChord(start, arc.Centre, chord)!.Value, ArcConstruction.FromCentreChord(start, arc.Centre, -chord)!.Value);
            var near = Near * (radius + Math.Abs(start.X) + Math.Abs(start.Y));
            return Math.Abs(shorter.EndPoint.DistanceTo(start) - chord) <= near && Math.Abs(longer.EndPoint.DistanceTo(start) - chord) <= near
                && shorter.StartPoint.IsNear(start, near) && shorter.Sweep.Degrees <= 180.0 && longer.Sweep.Degrees >= 180.0;
        });

    private static Arbitrary<double> Part() => Gen.Choose(1, 99).Select(percent => percent / 100.0).ToArbitrary();

    private static bool IsNear(ArcSegment? made, ArcSegment arc, double relative) => made is { } one
        && Math.Abs(one.Radius - arc.Radius) <= relative * arc.Radius && one.Centre.IsNear(arc.Centre, relative * arc.Radius) && Math.Abs(one.Sweep.Degrees - arc.Sweep.Degrees) <= relative * 360.0;

    private static void Same(ArcSegment? made, double x, double y, double radius, double start, double sweep)
    {
        var arc = Assert.NotNull(made);
        Assert.Equal([x, y, radius, start, sweep], new[] { arc.Centre.X, arc.Centre.Y, arc.Radius, arc.Start.Degrees, arc.Sweep.Degrees }.Select(value => Math.Round(value, 9) + 0.0));
    }
}
