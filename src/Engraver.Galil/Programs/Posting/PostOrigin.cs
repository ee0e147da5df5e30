namespace Engraver.Galil.Programs.Posting;

/// <summary>A work origin that is written into a program, counts by the controller's own zero.</summary>
/// <param name="Z">Of the drawing's height 0; null: the height of the tool at the start of the job.</param>
public sealed record PostOrigin(long X, long Y, int? Z);
