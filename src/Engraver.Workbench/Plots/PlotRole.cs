namespace Engraver.Workbench.Plots;

/// <summary>The place of a motion among those that are plotted together.</summary>
public enum PlotRole
{
    /// <summary>The planned motion.</summary>
    Plan,

    /// <summary>The running or last run, or the stored run that is shown over the drawing.</summary>
    Run,

    /// <summary>A stored run for comparison.</summary>
    Compared,
}
