namespace Engraver.Workbench.SerialTexts;

/// <summary>The content of the counter book.</summary>
/// <param name="Counters">The next number of each counter, in the order of their names.</param>
/// <param name="Plates">Plates that were started and are not confirmed, the oldest first.</param>
public sealed record CounterState(IReadOnlyList<CounterNumber> Counters, IReadOnlyList<StartedPlate> Plates);
