namespace Engraver.Workbench.Sending;

/// <summary>Progress of a transmission.</summary>
public sealed record SendProgress(int Lines, int TotalLines, long Characters, int Pauses);
