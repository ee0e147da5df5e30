namespace Engraver.Workbench.Plots;

/// <summary>A quantity of a motion that can be plotted over its time or its path.</summary>
public enum PlotQuantity
{
    /// <summary>Speed of the tool in XY, mm/min.</summary>
    Speed,

    /// <summary>Acceleration of the X axis, mm/s2.</summary>
    AccelerationX,

    /// <summary>Acceleration of the Y axis, mm/s2.</summary>
    AccelerationY,

    /// <summary>Distance of the motors from their commanded positions, mm.</summary>
    FollowingError,

    /// <summary>Distance from the drawing while the tool is on, mm.</summary>
    Deviation,

    /// <summary>Feed override in force, percent of the programmed feed.</summary>
    FeedOverride,

    /// <summary>Time in which the command handle is busy with an exchange, percent of the elapsed time.</summary>
    LinkLoad,

    /// <summary>Time by which a run is behind its plan on the path so far, without the time at rest, seconds.</summary>
    Lag,
}
