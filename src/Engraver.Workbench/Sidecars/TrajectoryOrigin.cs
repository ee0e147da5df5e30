using Engraver.Core.Offsets;
using Engraver.Core.Trajectories;

namespace Engraver.Workbench.Sidecars;

/// <summary>The source of a trajectory, used to detect edits and to recompute it.</summary>
/// <param name="Group">Common number of all trajectories of one contour, or of contours offset together, at one distance.</param>
/// <param name="Index">Index in the group at one height; 0 is first.</param>
/// <param name="Count">Number of trajectories in the group at one height.</param>
/// <param name="SourceFingerprint">Fingerprint of the curves of its entities (<see cref="DocumentTrajectory.Handles"/>) at that time.</param>
public sealed record TrajectoryOrigin(int Group, int Index, int Count, string SourceFingerprint)
{
    /// <summary>Offset distance, millimetres; null: it follows the drawing.</summary>
    public double? Offset { get; init; }

    /// <summary>Side of the offset; meaningless without an offset.</summary>
    public OffsetSide Side { get; init; }

    public CornerMode Corners { get; init; }
}
