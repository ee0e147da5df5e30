namespace Engraver.Galil.Programs;

/// <summary>A position of the two plane axes in counts, in the job's frame: drawing zero is 0,0. The controller's own zero may stand elsewhere.</summary>
public readonly record struct CountsPoint(int X, int Y);
