namespace Engraver.Core.Motion;

/// <summary>The parts in which a program was loaded and run one after the other.</summary>
/// <param name="lasts">For each part except the first: the number of moves that were made before it, and the last of them.</param>
public sealed class ProgramParts(IReadOnlyDictionary<int, ScheduledMove> lasts)
{
    /// <summary>A program that was loaded as a whole.</summary>
    public static ProgramParts Whole { get; } = new(new Dictionary<int, ScheduledMove>());

    /// <summary>Whether another part begins after this number of moves.</summary>
    public bool BeginAfter(int moves) => lasts.ContainsKey(moves);

    /// <summary>The last move before another part that begins after this number of moves; null where none begins.</summary>
    public ScheduledMove? LastBefore(int moves) => lasts.TryGetValue(moves, out var last) ? last : null;
}
