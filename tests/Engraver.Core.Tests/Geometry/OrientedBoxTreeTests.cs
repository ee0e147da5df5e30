using Engraver.Core.Geometry;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Geometry;

public class OrientedBoxTreeTests
{
    private static readonly Arbitrary<int> Seeds = Gen.Choose(0, int.MaxValue).ToArbitrary();

    [Property]
    public Property The_nearest_line_is_the_one_that_looking_at_all_would_find() =>
        Prop.ForAll(Seeds, seed =>
        {
            var (lines, here) = Lines(seed);

            var found = Tree(lines).Nearest(here, (item, place) => lines[item].DistanceTo(place), double.PositiveInfinity, -1.0, out var distance);

            var expected = Enumerable.Range(0, lines.Length).MinBy(i => lines[i].DistanceTo(here));
            return found == expected && distance == lines[expected].DistanceTo(here);
        });

    [Property]
    public Property Any_line_that_is_near_enough_will_do() =>
        Prop.ForAll(Seeds, seed =>
        {
            var (lines, here) = Lines(seed);

            var found = Tree(lines).Nearest(here, (item, place) => lines[item].DistanceTo(place), double.PositiveInfinity, 9.0, out var distance);

            return distance == lines[found].DistanceTo(here) && (distance <= 9.0 || distance == lines.Min(line => line.DistanceTo(here)));
        });

    /// <summary>Points of the path represent the path: a line near one of them must be found. Additional results are harmless.</summary>
    [Property]
    public Property Along_a_line_and_along_an_arc_is_every_line_that_comes_near() =>
        Prop.ForAll(Seeds, seed =>
        {
            var (lines, here) = Lines(seed);
            var random = new Random(seed);
            var tree = Tree(lines);
            Segment[] paths =
            [
                Segment.FromLine(here, here + new Vector2D(random.Next(-50, 50), random.Next(-50, 50))),
                Segment.FromArc(new ArcSegment(here, 1 + random.Next(60), Angle.FromDegrees(random.Next(360)), Angle.FromDegrees(random.Next(2) == 0 ? 1 + random.Next(360) : -1 - random.Next(360)))),
            ];
            return paths.All(path => Near(lines, path, 1.5).IsSubsetOf(Along(tree, path, 1.5)));
        });

    [Fact]
    public void An_empty_tree_answers_none()
    {
        var tree = OrientedBoxTree.Build([]);

        Assert.False(tree.ComesNear(Segment.FromLine(default, new Point2D(1, 0)), 1e9));
        Assert.Equal(-1, tree.Nearest(default, (_, _) => 0.0, double.PositiveInfinity, -1.0, out _));
    }

    /// <summary>Equal boxes cannot be separated by position or direction, and one far away must not turn the tree into a chain.</summary>
    [Fact]
    public void Boxes_on_one_another_and_boxes_ever_farther_away_are_divided_in_number()
    {
        OrientedBox[] boxes = [.. Enumerable.Range(0, 5000).Select(i => OrientedBox.Around(default, new Point2D(1, 1))), .. Enumerable.Range(0, 300).Select(i => OrientedBox.Around(new Point2D(Math.Pow(2.0, i), 0), new Point2D(Math.Pow(2.0, i), 1)))];
        var found = new HashSet<int>();

        OrientedBoxTree.Build(boxes).ComesNear(Segment.FromLine(new Point2D(0.5, 0.5), new Point2D(0.5, 0.6)), 0.1, item => !found.Add(item)); // none counts, so that all are tested

        Assert.Equal(5000, found.Count);
    }

    private static OrientedBoxTree Tree(LineSegment[] lines) => OrientedBoxTree.Build([.. lines.Select(line => OrientedBox.Around(line.Start, line.End))]);

    private static HashSet<int> Along(OrientedBoxTree tree, Segment path, double reach)
    {
        var found = new HashSet<int>();
        var any = tree.ComesNear(path, reach);
        tree.ComesNear(path, reach, item => !found.Add(item)); // none counts, so that all are tested
        Assert.Equal(found.Count > 0, any);
        return found;
    }

    private static HashSet<int> Near(LineSegment[] lines, Segment path, double reach) =>
        [.. Enumerable.Range(0, lines.Length).Where(i => Enumerable.Range(0, 101).Any(step => lines[i].DistanceTo(path.PointAt(step / 100.0)) <= reach))];

    /// <summary>Whole coordinates, so that ties happen; points, coincident lines, and one far away.</summary>
    private static (LineSegment[] Lines, Point2D Here) Lines(int seed)
    {
        var random = new Random(seed);
        Point2D Place(int size) => new(random.Next(size), random.Next(size));
        var size = 1 + random.Next(100);
        var lines = Enumerable.Range(0, random.Next(1, 200)).Select(_ => Place(size)).Select(start => new LineSegment(start, start + (Place(size) - Place(size)))).ToArray();
        if (random.Next(2) == 0) lines[^1] = new LineSegment(new Point2D(1e7, -1e7), new Point2D(1e7, 3));
        return (lines, Place(120));
    }
}
