namespace Engraver.Simulator;

/// <summary>What the owner of the machine burned with BN before the simulation begins (galil-dmc.md A.6); RS brings it back.</summary>
/// <param name="VectorSpeed">VS of both planes, counts/s.</param>
/// <param name="Acceleration">AC and DC of all axes, VA and VD of both planes, counts/s2.</param>
/// <param name="AxisSpeeds">SP of the axes from A on, counts/s; those left out keep the factory value.</param>
public sealed record BurnedMotion(int VectorSpeed, int Acceleration, IReadOnlyList<int> AxisSpeeds);
