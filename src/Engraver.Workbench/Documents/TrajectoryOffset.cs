using Engraver.Core.Offsets;

namespace Engraver.Workbench.Documents;

/// <summary>Offset trajectories.</summary>
/// <param name="Distance">Removal radius of the tool, mm, above 0: the offset of the last pass.</param>
/// <param name="Passes">At least 1.</param>
/// <param name="Step">Distance between two passes, mm.</param>
public sealed record TrajectoryOffset(double Distance, OffsetSide Side, int Passes, double Step);
