using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Tests.Sequencing.Chaining;

public class EndGridTests
{
    private const double Tolerance = 0.01;

    [Theory]
    [InlineData(1, 400)]
    [InlineData(2, 400)]
    [InlineData(3, 400)]
    [InlineData(4, 3000)] // more buckets than blocks
    public void The_only_neighbour_of_each_place_is_that_of_a_search_through_all(int seed, int count)
    {
        var places = Scattered(new Random(seed), count);
        var only = new EndGrid(places, Tolerance).OnlyNeighbours();
        for (var i = 0; i < places.Length; i++)
        {
            var near = NearOf(places, places[i]).Where(other => other != i).ToList();
            Assert.Equal(near.Count switch { 0 => EndGrid.None, 1 => near[0], _ => EndGrid.Several }, only[i]);
        }
    }

    [Theory]
    [InlineData(1, 3)]
    [InlineData(2, 20)]
    [InlineData(3, int.MaxValue)]
    public void What_was_taken_is_never_found_again_and_the_rest_always_is_also_after_searches_that_were_cut_short(int seed, int most)
    {
        var random = new Random(seed);
        var places = Scattered(random, 300);
        var (grid, taken, found) = (new EndGrid(places, Tolerance), new HashSet<int>(), new List<int>());
        for (var step = 0; step < 250; step++)
        {
            var place = random.Next(places.Length);
            if (taken.Add(place)) grid.Take(place);
            grid.TryNear(places[random.Next(places.Length)], _ => true, most, found);
            var here = places[random.Next(places.Length)];
            grid.Near(here, found);
            Assert.Equal(NearOf(places, here).Where(other => !taken.Contains(other)), found.Order());
        }
    }

    [Fact]
    public void A_crowd_is_not_searched_for_each_of_its_ends()
    {
        const int Crowd = 20_000;
        var grid = new EndGrid(Enumerable.Repeat(new Point2D(1.0, 1.0), Crowd).ToArray(), Tolerance);
        Assert.All(grid.OnlyNeighbours(), only => Assert.Equal(EndGrid.Several, only));
        Assert.InRange(grid.Comparisons, Crowd, 100L * Crowd);
    }

    /// <summary>Points in clusters a few tolerances wide, so that cells contain none, one or many.</summary>
    private static Point2D[] Scattered(Random random, int count)
    {
        var places = new Point2D[count];
        for (var i = 0; i < count; i++)
        {
            var cluster = random.Next(count / 8);
            places[i] = new Point2D(cluster + (random.NextDouble() * 4.0 * Tolerance), (cluster % 7) + (random.NextDouble() * 4.0 * Tolerance));
        }

        return places;
    }

    private static IEnumerable<int> NearOf(Point2D[] places, Point2D here) => Enumerable.Range(0, places.Length).Where(i => places[i].IsNear(here, Tolerance));
}
