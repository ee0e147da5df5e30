namespace Engraver.Workbench.Plots;

/// <summary>Origin of a plotted motion.</summary>
public enum MotionSource
{
    /// <summary>Computed from the motion program.</summary>
    Planned,

    /// <summary>Positions polled from a controller.</summary>
    Polled,

    /// <summary>Record of a simulated controller.</summary>
    Recorded,
}
