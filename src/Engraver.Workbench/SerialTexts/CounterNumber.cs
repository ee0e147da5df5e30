namespace Engraver.Workbench.SerialTexts;

/// <summary>A counter in the book.</summary>
/// <param name="Next">The number of the next plate.</param>
public sealed record CounterNumber(string Name, long Next);
