using Engraver.Core.Offsets;
using Engraver.Core.Trajectories;

namespace Engraver.Workbench.Sidecars;

/// <summary>From what a trajectory was made and how, so that an edit of that is noticed and the trajectory can be made anew.</summary>
/// <param name="Group">The same for all that one contour, or contours offset together, gave at one distance.</param>
/// <param name="Index">Which of them, at one height: 0 is first.</param>
/// <param name="Count">How many there were at one height.</param>
/// <param name="Drawn">Fingerprint of the curves of its entities (<see cref="DocumentTrajectory.Handles"/>) as they were.</param>
public sealed record TrajectoryOrigin(int Group, int Index, int Count, string Drawn)
{
    /// <summary>Distance of the offset that it follows, millimetres; null: it follows what is drawn.</summary>
    public double? Offset { get; init; }

    /// <summary>Side of the offset; without meaning where there is none.</summary>
    public OffsetSide Side { get; init; }

    public CornerMode Corners { get; init; }
}
