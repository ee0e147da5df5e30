using Engraver.Core.Machines;

namespace Engraver.Galil.Language;

/// <summary>The strategies as the seam passes them.</summary>
public static class JobModes
{
    private static readonly ExecutionStrategy[] s_strategies = [.. Enum.GetValues<JobMode>().Select(mode => new ExecutionStrategy(mode.ToString(), mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous))];

    /// <summary>In the order in which they are offered; the first is the default.</summary>
    public static IReadOnlyList<ExecutionStrategy> Strategies => s_strategies;

    /// <summary>The strategy of a job of this driver.</summary>
    public static JobMode Mode(this JobOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        return Of(options.Strategy);
    }

    public static ExecutionStrategy Strategy(this JobMode mode) => s_strategies[(int)mode];

    /// <param name="strategy">One of <see cref="Strategies"/>; null for the default.</param>
    /// <exception cref="ArgumentException">It belongs to another driver.</exception>
    public static JobMode Of(ExecutionStrategy? strategy)
    {
        if (strategy is null) return JobMode.Stream;
        var index = Array.IndexOf(s_strategies, strategy);
        return index >= 0 ? (JobMode)index : throw new ArgumentException($"'{strategy.Key}' is a strategy of another driver.", nameof(strategy));
    }
}
