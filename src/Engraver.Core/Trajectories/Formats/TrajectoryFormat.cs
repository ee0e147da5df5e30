namespace Engraver.Core.Trajectories.Formats;

/// <summary>Controller for which a trajectory is written.</summary>
public enum TrajectoryFormat
{
    /// <summary>The text of SACETraj: absolute positions (sace-xps-agie.md 1.3).</summary>
    Sace,

    /// <summary>The spline of an XPS controller's XYZ group.</summary>
    XpsSpline,

    /// <summary>Lines and arcs of an XPS controller's XY group.</summary>
    XpsLineArc,

    /// <summary>Positions, velocities and times of an XPS controller's MultipleAxes group.</summary>
    XpsPvt,
}
