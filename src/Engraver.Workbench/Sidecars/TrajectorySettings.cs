using Engraver.Core.Trajectories;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Sidecars;

/// <summary>Parameters of new trajectories (the settings of the SACE commands). Lengths in millimetres.</summary>
public sealed record TrajectorySettings
{
    public static TrajectorySettings Default { get; } = new();

    /// <summary>As for jobs until the operator changes it.</summary>
    public double MaxErrorMm { get; init; } = DrawingSettings.Default.MaxErrorMm;

    /// <summary>True: points depend on the curvature; false: equal steps of <see cref="SegmentLengthMm"/>.</summary>
    public bool DynamicDensity { get; init; } = true;

    /// <summary>Until the operator changes it, the step length of SACETraj.</summary>
    public double SegmentLengthMm { get; init; } = 0.5;

    /// <summary>Height of the machining plane.</summary>
    public double PlaneZ { get; init; }

    public CornerMode Corners { get; init; }

    public TrajectoryOptions ToOptions() => new(MaxErrorMm) { SegmentLength = DynamicDensity ? null : SegmentLengthMm, Corners = Corners, Z = PlaneZ };
}
