using Engraver.Core.Machines;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Sequencing.Ordering.Optimising;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>The searches of one job for the optimal order: by a number of steps, or for the seconds of the settings, which they share.</summary>
/// <param name="settings">Cost, seconds and machine.</param>
/// <param name="count">Number of searches.</param>
/// <param name="time">Ends a search.</param>
/// <param name="cancellation">Ends all of them; each keeps its best order.</param>
/// <param name="stop">Ends the searches for seconds only; null if it cannot be ended.</param>
internal sealed class OrderSearches(DrawingSettings settings, int count, TimeProvider time, CancellationToken cancellation, OrderStop? stop = null) : IDisposable
{
    private readonly CancellationTokenSource _stopped = new();
    private readonly List<CancellationTokenSource> _sources = [];

    /// <summary>Starts the time of the next search.</summary>
    public OrderSearch Next()
    {
        var search = new OrderSearch { Cost = CostOf(settings), Stop = cancellation };
        if (settings.OrderSeconds <= 0.0 || settings.Order != StrokeOrder.Optimal) return search;
        var limit = new CancellationTokenSource(TimeSpan.FromSeconds(settings.OrderSeconds / Math.Max(1, count)), time);
        var any = CancellationTokenSource.CreateLinkedTokenSource(limit.Token, cancellation, _stopped.Token);
        _sources.AddRange([any, limit]);
        stop?.Watch(_stopped);
        return search with { Steps = long.MaxValue, Searches = Environment.ProcessorCount, Stop = any.Token };
    }

    public void Dispose()
    {
        stop?.Watch(null);
        foreach (var source in _sources) source.Dispose();
        _stopped.Dispose();
    }

    /// <summary>The cost of a rapid.</summary>
    public static TravelCost CostOf(DrawingSettings settings)
    {
        var machine = settings.Machine;
        return settings.OrderCost == OrderCost.Distance ? TravelCost.Distance : TravelCost.Time(RapidOf(machine.Axes.X, machine), RapidOf(machine.Axes.Y, machine));
    }

    private static AxisRapid RapidOf(MachineAxis axis, MachineProfile machine) => new(machine.RapidMmPerMinute / 60.0, axis.Scale.LengthOf(machine.RapidAcceleration(axis)));
}
