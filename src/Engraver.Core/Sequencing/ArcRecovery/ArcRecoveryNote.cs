namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>One replacement: <paramref name="Lines"/> rows became the row <paramref name="Row"/> of the new table.</summary>
/// <param name="Row">Row of the arc or circle.</param>
/// <param name="Lines">Number of lines that it replaces.</param>
/// <param name="Deviation">Largest distance between the lines and the arc, mm.</param>
public readonly record struct ArcRecoveryNote(int Row, int Lines, double Deviation);
