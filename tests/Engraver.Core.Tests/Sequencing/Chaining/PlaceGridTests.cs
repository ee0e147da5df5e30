using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Sequencing.Chaining;

public class PlaceGridTests
{
    private static readonly Arbitrary<int> Seeds = Gen.Choose(0, int.MaxValue).ToArbitrary();

    /// <summary>While points are hidden one after the other until few are left, and some are shown again.</summary>
    [Property]
    public Property The_nearest_shown_place_is_the_one_that_looking_at_all_would_find() =>
        Prop.ForAll(Seeds, seed =>
        {
            var random = new Random(seed);
            var places = Places(random);
            if (PlaceGrid.TryBuild(places) is not { } grid) return;
            var shown = Enumerable.Range(0, places.Length).ToHashSet();
            for (var step = 0; step < 3 * places.Length; step++)
            {
                var place = random.Next(places.Length);
                if (random.Next(8) == 0) Show(place);
                else Hide(place);
                var within = random.Next(3) == 0 ? random.Next(12) : double.PositiveInfinity;
                var (from, except) = (new Point2D((random.NextDouble() * 140.0) - 20.0, (random.NextDouble() * 60.0) - 20.0), random.Next(-1, places.Length));

                var found = grid.Nearest(from, except, within, out var distance);

                var expected = shown.Where(one => one != except && places[one].DistanceTo(from) <= within).OrderBy(one => places[one].DistanceTo(from)).ThenBy(one => one).Select(one => (int?)one).FirstOrDefault() ?? -1;
                Assert.Equal((expected, expected < 0 ? within : places[expected].DistanceTo(from)), (found, distance));
            }

            void Show(int place)
            {
                grid.Show(place);
                shown.Add(place);
            }

            void Hide(int place)
            {
                grid.Hide(place);
                shown.Remove(place);
            }
        });

    [Fact]
    public void Of_equally_near_places_the_lower_number_is_found()
    {
        var grid = PlaceGrid.TryBuild([new(0, 0), new(7, 7), new(2, 0), new(0, 2), new(9, 0), new(2, 2)])!;

        Assert.Equal(0, grid.Nearest(new Point2D(1, 1), -1, double.PositiveInfinity, out _));
        grid.Hide(0);
        Assert.Equal(2, grid.Nearest(new Point2D(1, 1), -1, double.PositiveInfinity, out _));
        Assert.Equal(3, grid.Nearest(new Point2D(1, 1), 2, double.PositiveInfinity, out _));
    }

    /// <summary>A tool start that is far away, also so far that the square of the distance overflows.</summary>
    [Theory]
    [InlineData(1e9)]
    [InlineData(1e160)]
    [InlineData(-1e300)]
    public void From_far_away_the_nearest_place_is_found_too(double far)
    {
        var places = Places(new Random(8));
        var grid = PlaceGrid.TryBuild(places)!;
        var from = new Point2D(far, -far);

        var expected = Enumerable.Range(0, places.Length).MinBy(one => places[one].DistanceTo(from));
        Assert.Equal(expected, grid.Nearest(from, -1, double.PositiveInfinity, out _));
    }

    /// <summary>There the cells are smaller than the rounding of a coordinate.</summary>
    [Fact]
    public void Places_far_from_zero_have_no_grid() => Assert.Null(PlaceGrid.TryBuild([.. Enumerable.Range(0, 100).Select(i => new Point2D(1e14 + (i % 10), 1e14 + (i / 10)))]));

    [Fact]
    public void Every_place_is_told_once_cell_by_cell()
    {
        var places = Places(new Random(3));

        Assert.Equal(Enumerable.Range(0, places.Length), PlaceGrid.TryBuild(places)!.ByCell().Order());
    }

    /// <summary>If the points are crowded, each query would test all of them.</summary>
    [Theory]
    [InlineData(0.0)]
    [InlineData(1e-3)]
    public void Places_that_crowd_together_have_no_grid(double spread)
    {
        var random = new Random(5);
        Point2D[] places = [.. Enumerable.Range(0, 1000).Select(_ => new Point2D(spread * random.NextDouble(), spread * random.NextDouble())), new(1e6, 1e6)];

        Assert.Null(PlaceGrid.TryBuild(places));
    }

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    [InlineData(1e308)]
    public void Places_without_a_span_that_can_be_counted_have_no_grid(double far) => Assert.Null(PlaceGrid.TryBuild([new(-far, 0), new(1, 1), new(far, far)]));

    [Fact]
    public void No_places_and_a_single_one_have_no_grid()
    {
        Assert.Null(PlaceGrid.TryBuild([]));
        Assert.Null(PlaceGrid.TryBuild([new(1, 1)]));
    }

    /// <summary>Distributed over a plate, on few whole millimetres (many are equally near), or along a line.</summary>
    private static Point2D[] Places(Random random)
    {
        var kind = random.Next(3);
        return [.. Enumerable.Range(0, random.Next(2, 120)).Select(_ => kind switch
        {
            0 => new Point2D(random.NextDouble() * 100.0, random.NextDouble() * 20.0),
            1 => new Point2D(random.Next(12), random.Next(12)),
            _ => new Point2D(random.NextDouble() * 100.0, 5.0),
        })];
    }
}
