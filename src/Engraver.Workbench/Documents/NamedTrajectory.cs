using Engraver.Core.Trajectories.Formats;

namespace Engraver.Workbench.Documents;

/// <summary>A trajectory with the name of its file.</summary>
/// <param name="Source">Handle of its first entity; null if that has none, and for an offset.</param>
/// <param name="Seconds">Computation time.</param>
public sealed record NamedTrajectory(string FileName, TrajectoryFile File, string? Source, double Seconds);
