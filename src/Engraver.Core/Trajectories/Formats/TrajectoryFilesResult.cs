using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>The result for a contour.</summary>
/// <param name="Files">Files in the order of travel.</param>
/// <param name="Unproven">Number of runs for which the error could not be proven.</param>
public sealed record TrajectoryFilesResult(IReadOnlyList<TrajectoryFile> Files, IReadOnlyList<IReadOnlyList<Segment>> Unproven);
