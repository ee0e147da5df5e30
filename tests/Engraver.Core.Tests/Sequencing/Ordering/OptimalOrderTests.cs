using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Sequencing.Ordering.Optimising;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Sequencing.Ordering;

/// <summary>The order of the least travel complies with every constraint and is the best one of few strokes.</summary>
public class OptimalOrderTests
{
    private static readonly Point2D Start = new(-5, 3);
    private static readonly AxisRapid X = new(50.0, 256.0);
    private static readonly AxisRapid Y = new(20.0, 900.0);
    private static readonly SequencingOptions Optimal = UsualOptions.Sequencing with { Order = StrokeOrder.Optimal, ToolStart = Start, ToolEnd = Start };

    public static TheoryData<int> Small => [.. Enumerable.Range(1, 24)];

    [Theory]
    [MemberData(nameof(Small))]
    public void Few_strokes_have_the_order_and_the_starts_of_an_exhaustive_search(int seed)
    {
        var strokes = new RandomStrokes(seed, 5, levels: 1 + (seed % 3));

        var travel = Sequencer.Order(strokes.Chain(), Optimal).TravelAndBack;

        Assert.Equal(ExhaustiveOrder.LeastCost(strokes.All, Start, Start, Distance), travel, 1e-5);
    }

    [Fact]
    public void A_tool_that_stays_after_the_last_stroke_need_not_return()
    {
        var strokes = new RandomStrokes(7, 5, 2);

        var travel = Sequencer.Order(strokes.Chain(), Optimal with { ToolEnd = null }).Travel;

        Assert.Equal(ExhaustiveOrder.LeastCost(strokes.All, Start, null, Distance), travel, 1e-5);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void The_time_of_the_rapids_is_minimised(int seed)
    {
        var strokes = new RandomStrokes(seed, 5, 2);

        var order = Sequencer.Order(strokes.Chain(), Optimal with { Search = new OrderSearch { Cost = TravelCost.Time(X, Y) } });

        Assert.Equal(ExhaustiveOrder.LeastCost(strokes.All, Start, Start, Seconds), CostOf(order, Seconds), 1e-5);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(2, 1)]
    [InlineData(3, 2)]
    [InlineData(4, 2)]
    [InlineData(5, 3)]
    [InlineData(6, 3)]
    public void The_search_comes_within_one_percent_of_the_best_order_of_eleven_strokes(int seed, int levels)
    {
        var problem = ProblemOf(new RandomStrokes(seed, 11, levels));

        var found = new IteratedSearch<DistanceMeasure>(problem, Neighbors.Find(problem, default(DistanceMeasure)), default, 0).Run(new OrderSearch { Steps = 20_000 });

        var best = ExactOrder<DistanceMeasure>.TryFind(problem, default)!.Value.Cost;
        Assert.InRange(found, best - 1e-6, 1.01 * best);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(2, 2)]
    [InlineData(3, 4)]
    [InlineData(4, 4)]
    public void Every_contour_is_cut_once_and_inner_contours_first(int seed, int levels)
    {
        var strokes = new RandomStrokes(seed, 120, levels);
        var chained = strokes.Chain();

        var order = Sequencer.Order(chained, Optimal with { Search = new OrderSearch { Steps = 2000 } });

        Assert.Equal(Enumerable.Range(0, chained.Kept.Count).Select(chained.Kept.EntityIndexOf).Order(), order.Strokes.SelectMany(stroke => stroke.Moves).Select(move => move.EntityIndex).Order());
        Assert.All(order.Strokes, stroke => Assert.True(stroke.Inside < 0 || stroke.Inside > stroke.Index));
        Assert.Equal(strokes.All.Count(stroke => stroke.Around >= 0), order.Strokes.Count(stroke => stroke.Inside >= 0));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    public void It_is_shorter_than_the_nearest_order_and_the_same_every_time(int levels)
    {
        var chained = new RandomStrokes(9, 100, levels).Chain();
        var nearest = Sequencer.Order(chained, Optimal with { Order = StrokeOrder.Nearest }).TravelAndBack;

        var (order, again) = (Sequencer.Order(chained, Optimal), Sequencer.Order(chained, Optimal));

        Assert.True(order.TravelAndBack < 0.95 * nearest, $"{order.TravelAndBack} of {nearest}");
        Assert.Equal(StartsOf(order), StartsOf(again));
    }

    /// <summary>The search ends long before it reaches the best order, so that every influence of the numbers of the contours would show.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void The_order_of_the_drawing_does_not_change_it(int seed)
    {
        var (strokes, hasty) = (new RandomStrokes(seed, 120, 3), Optimal with { Search = new OrderSearch { Steps = 100 } });
        int[] shuffled = [.. Enumerable.Range(0, 120).Reverse()];
        new Random(seed).Shuffle(shuffled);

        var (travel, other) = (Sequencer.Order(strokes.Chain(), hasty).TravelAndBack, Sequencer.Order(strokes.Chain(shuffled), hasty).TravelAndBack);

        Assert.Equal(travel, other, 1e-6);
    }

    [Fact]
    public void A_stopped_search_keeps_a_valid_order()
    {
        var chained = new RandomStrokes(3, 150, 4).Chain();
        using var stop = new CancellationTokenSource();
        var progress = new CancellingProgress(stop);

        var order = Sequencer.Order(chained, Optimal with { Search = new OrderSearch { Steps = long.MaxValue, Searches = 2, Stop = stop.Token, Progress = progress } });

        Assert.Equal(chained.Chain.Contours.Count, order.Strokes.Count);
        Assert.All(order.Strokes, stroke => Assert.True(stroke.Inside < 0 || stroke.Inside > stroke.Index));
    }

    [Fact]
    public void A_search_of_no_steps_keeps_the_nearest_order()
    {
        var chained = new RandomStrokes(3, 60, 3).Chain();

        var order = Sequencer.Order(chained, Optimal with { Search = new OrderSearch { Steps = 0 } });

        Assert.Equal(StartsOf(Sequencer.Order(chained, Optimal with { Order = StrokeOrder.Nearest })), StartsOf(order));
    }

    [Fact]
    public void The_requested_contour_comes_first_after_what_is_inside_it()
    {
        var strokes = new RandomStrokes(4, 40, 3);
        var outer = strokes.All.Select(stroke => stroke.Around).Where(around => around >= 0 && strokes.All[around].Around < 0).Max();
        var place = strokes.All[outer].Entries[2].Start;
        var inner = Enumerable.Range(0, 40).Count(stroke => IsInside(strokes.All, stroke, outer));

        var order = Sequencer.Order(strokes.Chain(), Optimal with { Entry = new EntryRequest.AtPlace(place) });

        Assert.Equal(place, order.Strokes[inner].Start);
        Assert.All(order.Strokes.Take(inner), stroke => Assert.InRange(stroke.Inside, 1, inner));
    }

    private static bool IsInside(IReadOnlyList<RandomStrokes.Stroke> strokes, int stroke, int outer)
    {
        while (strokes[stroke].Around >= 0 && strokes[stroke].Around != outer) stroke = strokes[stroke].Around;
        return strokes[stroke].Around == outer;
    }

    private static double Distance(Point2D from, Point2D to) => from.DistanceTo(to);

    /// <summary>Written by the formula of uniform acceleration, not by the optimiser's.</summary>
    private static double Seconds(Point2D from, Point2D to) => Math.Max(Seconds(Math.Abs(to.X - from.X), X), Seconds(Math.Abs(to.Y - from.Y), Y));

    private static double Seconds(double distance, AxisRapid axis) => axis.Speed * axis.Speed > distance * axis.Acceleration
        ? 2.0 * Math.Sqrt(distance / axis.Acceleration)
        : (distance / axis.Speed) + (axis.Speed / axis.Acceleration);

    private static double CostOf(SequencingResult order, Func<Point2D, Point2D, double> cost)
    {
        var (sum, tool) = (0.0, Start);
        foreach (var stroke in order.Strokes) (sum, tool) = (sum + cost(tool, stroke.Start), stroke.End);
        return sum + cost(tool, Start);
    }

    private static List<(Point2D, Point2D)> StartsOf(SequencingResult order) => [.. order.Strokes.Select(stroke => (stroke.Start, stroke.End))];

    /// <summary>In the order of the strokes, inner ones first.</summary>
    private static OrderProblem ProblemOf(RandomStrokes strokes)
    {
        var problem = new OrderProblem(Start, Start);
        var count = strokes.All.Count;
        for (var stroke = count - 1; stroke >= 0; stroke--)
        {
            var entries = strokes.All[stroke].Entries;
            problem.Add(entries[0].Start == entries[0].End ? NodeKind.Closed : NodeKind.Open, [.. entries.Select(entry => entry.Start)], 0);
            if (strokes.All[stroke].Around is >= 0 and var around) problem.Require(count - stroke, count - around);
        }

        return problem;
    }

    /// <summary>Stops the search when it reports that it has started.</summary>
    private sealed class CancellingProgress(CancellationTokenSource stop) : IProgress<double>
    {
        public void Report(double value) => stop.Cancel();
    }
}
