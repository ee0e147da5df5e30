using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>The result for a contour.</summary>
/// <param name="Trajectories">Trajectories in the order of travel.</param>
/// <param name="Unproven">Runs for which no spline could be proven to be within the error, for example at a cusp inside a curve.</param>
public sealed record TrajectoryResult(IReadOnlyList<Trajectory> Trajectories, IReadOnlyList<IReadOnlyList<Segment>> Unproven);
