using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Reshaping;

/// <summary>TRIM, EXTEND and BREAK as geometry: known figures, and the removed and the remaining parts together are the whole.</summary>
public class PathCutTests
{
    private static readonly EntityPath s_circle = new([Segment.FromArc(new ArcSegment(default, 5.0, Angle.Zero, Angle.FullTurn))], true);

    private static readonly Gen<Point2D> s_places = from x in Gen.Choose(-50_000, 50_000) from y in Gen.Choose(-50_000, 50_000) select new Point2D(x / 1000.0, y / 1000.0);

    private static readonly Gen<Segment> s_lines = from a in s_places from b in s_places where a.DistanceTo(b) > 0.1 select Segment.FromLine(a, b);

    private static readonly Gen<EntityPath> s_paths = Gen.OneOf(
        s_lines.Select(line => new EntityPath([line], false)),
        Arcs.Any.Generator.Select(arc => new EntityPath([Segment.FromArc(arc)], arc.IsFullTurn)),
        FreeCurves.Ellipses.Generator.Select(curve => new EntityPath([Segment.FromCurve(curve)], curve.IsClosed)),
        from corners in s_places.ArrayOf(5) from closed in Gen.Elements(true, false) select Polygon(corners, closed));

    private static readonly Arbitrary<(EntityPath Path, Segment[] Edges, double At)> s_cuts =
        (from path in s_paths from edges in s_lines.ArrayOf(4) from at in Gen.Choose(0, 1000) select (path, edges, at / 1000.0)).ToArbitrary();

    [Fact]
    public void A_line_loses_what_lies_between_two_edges()
    {
        var path = new EntityPath([Line(0, 0, 10, 0)], false);
        var cut = PathCut.Trim(path, path.Crossings([Line(3, -1, 3, 1), Line(7, -1, 7, 1), Line(0, -1, 0, 1)]), path.Nearest(new Point2D(5, 0.1)))!;

        Assert.Equal([new PathRange(0, 0.3, 0.7, new Point2D(3, 0), new Point2D(7, 0))], cut.Removed);
        Assert.Equal([(new Point2D(0, 0), new Point2D(3, 0)), (new Point2D(7, 0), new Point2D(10, 0))], cut.Remaining.Select(pieces => (pieces[0].Start, pieces[^1].End)));
        Assert.Null(PathCut.Trim(path, path.Crossings([Line(0, -1, 0, 1)]), path.Start));
    }

    [Fact]
    public void A_circle_becomes_the_arc_on_the_other_side_of_its_edge()
    {
        var cut = PathCut.Trim(s_circle, s_circle.Crossings([Line(3, -9, 3, 9)]), s_circle.Nearest(new Point2D(5, 0)))!;
        var kept = Assert.Single(Assert.Single(cut.Remaining)).Of(s_circle.Parts[0]).Arc;

        Assert.Equal(Math.Acos(3.0 / 5.0) * 180.0 / Math.PI, kept.Start.Degrees, 12);
        Assert.Equal(360.0 - (2.0 * Math.Acos(3.0 / 5.0) * 180.0 / Math.PI), kept.Sweep.Degrees, 10);
        Assert.Null(PathCut.Trim(s_circle, s_circle.Crossings([Line(5, -9, 5, 9)]), s_circle.Nearest(default)));
    }

    [Fact]
    public void A_bulged_polyline_is_cut_within_its_arc()
    {
        var arc = Segment.FromArc(ArcSegment.FromBulge(new Point2D(10, 0), new Point2D(10, 10), 1.0));
        var path = new EntityPath([Line(0, 0, 10, 0), arc, Line(10, 10, 0, 10)], false);
        var cut = PathCut.Trim(path, path.Crossings([Line(10, 5, 30, 5)]), path.Nearest(new Point2D(0, 10)))!;
        var kept = Assert.Single(cut.Remaining);

        Assert.Equal(2, kept.Count);
        Assert.True(kept[^1].Of(arc).End.IsNear(new Point2D(15, 5), 1e-12));
        Assert.Equal(90.0, kept[^1].Of(arc).Arc.Sweep.Degrees, 10);
    }

    [Fact]
    public void A_break_goes_from_the_first_place_to_the_second_and_round_a_circle_counter_clockwise()
    {
        var (right, up) = (s_circle.Nearest(new Point2D(9, 0)), s_circle.Nearest(new Point2D(0, 9)));

        Assert.Equal((90.0, 270.0), Sweep(PathCut.Break(s_circle, right, up)));
        Assert.Equal((0.0, 90.0), Sweep(PathCut.Break(s_circle, up, right)));
        var parted = PathCut.Break(new EntityPath([Line(0, 0, 10, 0)], false), new PathPlace(0, 0.4, new Point2D(4, 0)), new PathPlace(0, 0.4, new Point2D(4, 0)));
        Assert.Equal((0, 2), (parted.Removed.Count, parted.Remaining.Count));
    }

    [Fact]
    public void A_line_goes_on_to_the_next_edge_and_an_arc_along_its_circle()
    {
        var line = new EntityPath([Line(0, 0, 10, 0)], false);
        var arc = new EntityPath([Segment.FromArc(new ArcSegment(default, 5.0, Angle.Zero, Angle.FromDegrees(60.0)))], false);
        Segment[] edges = [Line(20, -9, 20, 9), Line(14, 1, 14, 9), Line(-2, -9, -2, 9), Line(-3, -9, -3, 9)];

        Assert.Equal(new PathRange(0, 0.0, 2.0, new Point2D(0, 0), new Point2D(20, 0)), PathExtension.Find(line, edges, new Point2D(9, 0))!.Value.Grown);
        Assert.Equal(new Point2D(14, 0), PathExtension.Find(line, edges, new Point2D(9, 0), lengthened: true)!.Value.Grown.End);
        Assert.Equal(new Point2D(-2, 0), PathExtension.Find(line, edges, new Point2D(1, 0))!.Value.Grown.Start);
        var grown = PathExtension.Find(arc, edges, arc.Parts[0].End)!.Value.Grown.Of(arc.Parts[0]).Arc;
        Assert.Equal((0.0, Math.Acos(-2.0 / 5.0) * 180.0 / Math.PI), (grown.Start.Degrees, Math.Round(grown.Sweep.Degrees, 12)), ((double A, double B) a, (double A, double B) b) => a.A == b.A && Math.Abs(a.B - b.B) < 1e-10);
        Assert.Null(PathExtension.Find(line, [Line(0, 5, 9, 5)], new Point2D(9, 0)));
        Assert.Null(PathExtension.Find(s_circle, edges, default));
    }

    /// <summary>The removed and the remaining parts together have the length of the whole, meet at the cuts, and every point of the whole is on one of
    /// them. Only paths that an edge crosses count as cases.</summary>
    [Property(MaxRejected = 10_000)]
    public Property What_is_trimmed_and_what_is_left_are_the_whole() => Prop.ForAll(s_cuts, drawn =>
    {
        var (path, edges, at) = drawn;
        var cut = PathCut.Trim(path, path.Crossings(edges), path.Nearest(path.Parts[0].PointAt(at)));
        return Prop.When(cut is not null, () => IsWhole(path, cut!));
    });

    private static bool IsWhole(EntityPath path, PathCut cut)
    {
        var left = cut.Remaining.Append(cut.Removed).SelectMany(pieces => pieces).Select(piece => piece.Of(path.Parts[piece.Part])).ToList();
        var (whole, size) = (path.Parts.Sum(part => part.Length), path.Parts.Sum(part => part.Length + part.Bounds.Width) + 100.0);
        return Math.Abs(left.Sum(segment => segment.Length) - whole) <= 1e-8 * size
            && path.Parts.All(part => new[] { 0.0, 0.2, 0.5, 0.9, 1.0 }.All(fraction => left.Min(segment => segment.DistanceTo(part.PointAt(fraction))) <= 1e-8 * size))
            && cut.Remaining.All(pieces => pieces.Zip(pieces.Skip(1)).All(pair => pair.First.End.IsNear(pair.Second.Start, 1e-8 * size)));
    }

    private static (double Start, double Sweep) Sweep(PathCut cut) => Assert.Single(Assert.Single(cut.Remaining)).Of(s_circle.Parts[0]).Arc is var arc ? (arc.Start.Positive().Degrees, arc.Sweep.Degrees) : default;

    private static EntityPath Polygon(Point2D[] corners, bool closed) =>
        new([.. corners.Zip(closed ? [.. corners.Skip(1), corners[0]] : corners.Skip(1)).Where(pair => pair.First != pair.Second).Select(pair => Segment.FromLine(pair.First, pair.Second)).DefaultIfEmpty(Line(0, 0, 1, 0))], closed && corners.Distinct().Count() > 1);

    private static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));
}
