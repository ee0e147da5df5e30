using Engraver.Core.Geometry;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Geometry;

public class BoxTreeTests
{
    private static readonly Arbitrary<int> Seeds = Gen.Choose(0, int.MaxValue).ToArbitrary();

    [Property]
    public Property The_nearest_item_is_the_one_that_looking_at_all_would_find() =>
        Prop.ForAll(Seeds, seed =>
        {
            var (places, here) = Places(seed);
            var tree = BoxTree.Build(places);

            var found = tree.Nearest(here, Distance(places), double.PositiveInfinity, out var distance);

            var expected = Enumerable.Range(0, places.Length).MinBy(i => places[i].DistanceTo(here));
            return found == expected && distance == places[expected].DistanceTo(here);
        });

    /// <summary>The lower number is chosen among equals; testing all of them each time would make a star of lines quadratic.</summary>
    [Fact]
    public void Of_many_items_in_one_place_few_are_looked_at()
    {
        const int Items = 4_000;
        var random = new Random(7);
        var places = Enumerable.Range(0, Items).Select(_ => random.Next(2) == 0 ? new Point2D(1, 2) : new Point2D(1, 3)).ToArray();
        var tree = BoxTree.Build(places);
        var (looks, order) = (0, new List<int>());
        while (tree.Nearest(new Point2D(1, 1), Counted, double.PositiveInfinity, out _) is >= 0 and var item)
        {
            order.Add(item);
            tree.Hide(item);
        }

        Assert.Equal(Enumerable.Range(0, Items).OrderBy(item => places[item].Y).ThenBy(item => item), order);
        Assert.InRange(looks, Items, 4 * Items);

        double Counted(int item, Point2D place)
        {
            looks++;
            return places[item].DistanceTo(place);
        }
    }

    [Property]
    public Property The_boxes_around_a_box_are_those_that_looking_at_all_would_find() =>
        Prop.ForAll(Seeds, seed =>
        {
            var random = new Random(seed);
            var boxes = Enumerable.Range(0, random.Next(1, 200)).Select(_ => new Bounds2D(random.Next(10), random.Next(10), 10 + random.Next(10), 10 + random.Next(10))).ToArray();
            var asked = new Bounds2D(random.Next(12), random.Next(12), 8 + random.Next(12), 8 + random.Next(12));
            var hidden = random.Next(boxes.Length);
            var tree = BoxTree.Build(boxes);
            tree.Hide(hidden);
            var found = new List<int>();

            tree.Containing(asked, found);

            return found.Order().SequenceEqual(Enumerable.Range(0, boxes.Length).Where(i => i != hidden && boxes[i].Contains(asked)));
        });

    /// <summary>The contours of a star all meet in its middle, so that most boxes contain most points; but few contain another contour completely.</summary>
    [Theory]
    [InlineData(2_000)]
    [InlineData(20_000)]
    public void Of_the_wedges_of_a_star_few_lie_around_one(int wedges)
    {
        var boxes = Enumerable.Range(0, wedges).Select(i => Bounds2D.FromCorners(default, Point2D.Origin + Vector2D.FromPolar(50.0, Angle.FromDegrees(360.0 * i / wedges)))).ToArray();
        var tree = BoxTree.Build(boxes);
        var found = new List<int>();

        foreach (var box in boxes) tree.Containing(box, found);

        Assert.InRange(found.Count, wedges, 3 * wedges);
    }

    [Property]
    public Property Hidden_items_are_not_found_until_they_are_shown_again() =>
        Prop.ForAll(Seeds, seed =>
        {
            var (places, here) = Places(seed);
            var tree = BoxTree.Build(places);
            for (var i = 0; i < places.Length; i++)
            {
                tree.Hide(i);
                tree.Hide(i);
                if (i % 3 == 0) tree.Show(i);
            }

            var found = tree.Nearest(here, Distance(places), double.PositiveInfinity, out _);

            return found == Enumerable.Range(0, places.Length).Where(i => i % 3 == 0).MinBy(i => places[i].DistanceTo(here));
        });

    [Property]
    public Property Overlapping_finds_every_box_that_touches() =>
        Prop.ForAll(Seeds, seed =>
        {
            var (places, here) = Places(seed);
            var boxes = places.Select(place => new Bounds2D(place.X, place.Y, place.X + 7, place.Y + 3)).ToArray();
            var window = new Bounds2D(here.X, here.Y, here.X + 20, here.Y + 20);
            var found = new List<int>();

            BoxTree.Build(boxes).Overlapping(window, found);

            var expected = Enumerable.Range(0, boxes.Length).Where(i =>
                boxes[i].MinX <= window.MaxX && boxes[i].MaxX >= window.MinX && boxes[i].MinY <= window.MaxY && boxes[i].MaxY >= window.MinY);
            return found.Order().SequenceEqual(expected);
        });

    [Fact]
    public void Nothing_lies_nearer_than_the_limit()
    {
        var tree = BoxTree.Build([new Point2D(3, 4)]);

        Assert.Equal(-1, tree.Nearest(default, (_, place) => place.DistanceTo(new Point2D(3, 4)), 4.99, out var distance));
        Assert.Equal(4.99, distance);
        Assert.Equal(0, tree.Nearest(default, (_, place) => place.DistanceTo(new Point2D(3, 4)), 5.0, out _));
    }

    [Fact]
    public void An_empty_tree_and_a_tree_with_everything_hidden_answer_none()
    {
        var hidden = BoxTree.Build([default(Point2D)]);
        hidden.Hide(0);

        Assert.Equal(-1, BoxTree.Build(ReadOnlySpan<Point2D>.Empty).Nearest(default, (_, _) => 0.0, double.PositiveInfinity, out _));
        Assert.Equal(-1, hidden.Nearest(default, (_, _) => 0.0, double.PositiveInfinity, out _));
    }

    private static BoxTree.Measure Distance(Point2D[] places) => (item, place) => places[item].DistanceTo(place);

    /// <summary>Clusters with an outlier far away, and whole coordinates so that ties happen.</summary>
    private static (Point2D[] Places, Point2D Here) Places(int seed)
    {
        var random = new Random(seed);
        var places = Enumerable.Range(0, random.Next(1, 200)).Select(_ => new Point2D(random.Next(100), random.Next(100))).ToArray();
        if (random.Next(2) == 0) places[^1] = new Point2D(1e7, -1e7);
        return (places, new Point2D(random.Next(-20, 120), random.Next(-20, 120)));
    }
}
