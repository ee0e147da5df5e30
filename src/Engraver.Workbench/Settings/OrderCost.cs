namespace Engraver.Workbench.Settings;

/// <summary>What the optimal order of strokes minimises.</summary>
public enum OrderCost
{
    /// <summary>The distance of the rapids.</summary>
    Distance,

    /// <summary>The time of the rapids on the machine of the job.</summary>
    Time,
}
