namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>One round of a search.</summary>
/// <param name="Steps">Number of random changes.</param>
/// <param name="Heat">By how much worse a result may be at first, in mean links of the tour; it decreases to 0.</param>
/// <param name="IsReversed">It starts from the best order in reverse, as far as the constraints allow.</param>
internal readonly record struct OrderRound(long Steps, double Heat, bool IsReversed);
