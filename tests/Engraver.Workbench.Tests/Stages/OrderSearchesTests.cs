using Engraver.Core.Machines;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Sequencing.Ordering.Optimising;
using Engraver.TestKit;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Tests.Stages;

/// <summary>The searches for the optimal order end by steps or by time, and minimise the time of this machine's rapids or their distance.</summary>
public class OrderSearchesTests
{
    private static readonly DrawingSettings s_optimal = new() { Order = StrokeOrder.Optimal };

    [Fact]
    public void Without_seconds_a_search_has_the_steps_of_its_size_on_one_core()
    {
        using var searches = new OrderSearches(s_optimal, 1, new ManualTimeProvider(), CancellationToken.None);

        var search = searches.Next();

        Assert.Equal((null, 1), (search.Steps, search.Searches));
    }

    [Fact]
    public void The_searches_of_a_job_share_the_seconds()
    {
        var time = new ManualTimeProvider();
        using var searches = new OrderSearches(s_optimal with { OrderSeconds = 10.0 }, 2, time, CancellationToken.None);

        var first = searches.Next();
        time.Advance(TimeSpan.FromSeconds(4.9));
        Assert.False(first.Stop.IsCancellationRequested);
        time.Advance(TimeSpan.FromSeconds(0.2));
        Assert.True(first.Stop.IsCancellationRequested);
        var second = searches.Next();
        Assert.Equal((long.MaxValue, Environment.ProcessorCount), (second.Steps, second.Searches));
        Assert.False(second.Stop.IsCancellationRequested);
    }

    [Fact]
    public void The_operator_stops_a_search_of_seconds()
    {
        using var cancel = new CancellationTokenSource();
        using var searches = new OrderSearches(s_optimal with { OrderSeconds = 10.0 }, 1, new ManualTimeProvider(), cancel.Token);
        var search = searches.Next();

        cancel.Cancel();

        Assert.True(search.Stop.IsCancellationRequested);
    }

    [Fact]
    public void The_operator_ends_the_searches_of_seconds_once_and_the_job_continues()
    {
        var stop = new OrderStop();
        Assert.False(stop.TryStop());
        using (var searches = new OrderSearches(s_optimal with { OrderSeconds = 10.0 }, 2, new ManualTimeProvider(), CancellationToken.None, stop))
        {
            var first = searches.Next();
            Assert.False(first.Stop.IsCancellationRequested);
            Assert.True(stop.TryStop());
            Assert.True(first.Stop.IsCancellationRequested);
            Assert.True(searches.Next().Stop.IsCancellationRequested);
            Assert.False(stop.TryStop());
        }

        Assert.False(stop.TryStop());
    }

    [Fact]
    public void The_operator_does_not_end_a_search_of_steps()
    {
        var stop = new OrderStop();
        using var searches = new OrderSearches(s_optimal, 1, new ManualTimeProvider(), CancellationToken.None, stop);

        var search = searches.Next();

        Assert.False(stop.TryStop());
        Assert.False(search.Stop.IsCancellationRequested);
    }

    [Fact]
    public void The_cost_is_the_time_of_each_axis_of_the_machine_or_the_distance()
    {
        var machine = new MachineProfile { Axes = MachineAxes.FromScale(1000.0, -500.0), RapidMmPerMinute = 3000.0, AccelerationCounts = 256_000, AccelerationY = 64_000 };

        Assert.Equal(TravelCost.Time(new AxisRapid(50.0, 256.0), new AxisRapid(50.0, 128.0)), OrderSearches.CostOf(s_optimal with { Machine = machine }));
        Assert.Equal(TravelCost.Distance, OrderSearches.CostOf(s_optimal with { Machine = machine, OrderCost = OrderCost.Distance }));
    }
}
