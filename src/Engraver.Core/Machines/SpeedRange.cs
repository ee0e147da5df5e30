namespace Engraver.Core.Machines;

/// <summary>Speeds that a capability allows: counts/s for a jog, factors of the programmed feed for an override.</summary>
public sealed record SpeedRange(double Min, double Max);
