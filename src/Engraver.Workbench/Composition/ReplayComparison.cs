namespace Engraver.Workbench.Composition;

/// <summary>Comparison of a replay and a record.</summary>
/// <param name="MatchingLines">Number of matching lines from the start, including the heading.</param>
/// <param name="RecordLine">First differing line of the record; null if it has ended or nothing differs.</param>
/// <param name="ReplayLine">First differing line of the replay; null if it has ended or nothing differs.</param>
public sealed record ReplayComparison(int MatchingLines, string? RecordLine, string? ReplayLine)
{
    public bool IsSame => RecordLine is null && ReplayLine is null;
}
