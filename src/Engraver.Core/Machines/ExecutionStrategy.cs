namespace Engraver.Core.Machines;

/// <summary>A way in which a driver runs a job on its controller. The driver names its strategies; elsewhere a strategy is only selected, shown and passed
/// on.</summary>
/// <param name="Keyword">Its name as prompts offer it; the capitals are its short form.</param>
/// <param name="Style">How motion must be generated for it.</param>
public sealed record ExecutionStrategy(string Keyword, MotionStyle Style)
{
    /// <summary>Its name in options, in the history and in journals.</summary>
    public string Key { get; } = Keyword.ToLowerInvariant();
}
