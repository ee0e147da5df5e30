namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Extent and purpose of the search for the optimal order. The same values give the same order, unless the search is stopped.</summary>
public sealed record OrderSearch
{
    public static OrderSearch Default { get; } = new();

    /// <summary>What is minimised.</summary>
    public TravelCost Cost { get; init; } = TravelCost.Distance;

    /// <summary>Number of changes that are tried after the first improvement; null: by the number of strokes, at most about 2 s of processor time for 2,000
    /// strokes, and no search for so many strokes that it would take longer than everything else; <see cref="long.MaxValue"/>: until it is stopped.</summary>
    public long? Steps { get; init; }

    /// <summary>Number of searches that run at the same time with different random numbers; the best result is used. At least 1.</summary>
    public int Searches { get; init; } = 1;

    /// <summary>Stops the search, which keeps its best order: for a caller that limits the time, or an operator who does not need to wait.</summary>
    public CancellationToken Stop { get; init; }

    /// <summary>Receives the completed fraction of the steps, 0 to 1.</summary>
    public IProgress<double>? Progress { get; init; }
}
