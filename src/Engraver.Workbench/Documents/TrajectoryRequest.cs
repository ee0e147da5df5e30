using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;

namespace Engraver.Workbench.Documents;

/// <summary>Parameters of the requested trajectories.</summary>
public sealed record TrajectoryRequest
{
    public TrajectoryFormat Format { get; init; } = TrajectoryFormat.Sace;

    public CornerMode Corners { get; init; } = CornerMode.Stop;

    /// <summary>Null for the dynamic density.</summary>
    public double? SegmentLength { get; init; }

    /// <summary>Height of the machining plane, mm.</summary>
    public double Z { get; init; }

    /// <summary>Null for trajectories on the contours themselves.</summary>
    public TrajectoryOffset? Offset { get; init; }
}
