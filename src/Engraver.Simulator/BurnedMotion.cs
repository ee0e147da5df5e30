namespace Engraver.Simulator;

/// <summary>Parameters burned with BN before the simulation starts (galil-dmc.md A.6); RS restores them.</summary>
/// <param name="VectorSpeed">VS of both planes, counts/s.</param>
/// <param name="Acceleration">AC and DC of all axes, VA and VD of both planes, counts/s2.</param>
/// <param name="AxisSpeeds">SP of the axes from A on, counts/s; null and omitted axes keep the factory value.</param>
public sealed record BurnedMotion(int VectorSpeed, int Acceleration, IReadOnlyList<int?> AxisSpeeds);
