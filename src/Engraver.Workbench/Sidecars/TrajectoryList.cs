namespace Engraver.Workbench.Sidecars;

/// <summary>The trajectories of a document, and the settings of the next ones. Immutable.</summary>
public sealed record TrajectoryList
{
    public static TrajectoryList Empty { get; } = new();

    /// <summary>In the order in which they are exported; with unique names.</summary>
    public IReadOnlyList<DocumentTrajectory> All { get; init; } = [];

    public TrajectorySettings Settings { get; init; } = new();

    /// <summary>The number in the name of the next trajectory. It only increases, so that names are not reused.</summary>
    public int NextNumber { get; init; }

    /// <summary>Index of a name, case-insensitive; -1 for none.</summary>
    public int IndexOf(string name)
    {
        for (var i = 0; i < All.Count; i++)
        {
            if (All[i].Name.Equals(name, StringComparison.OrdinalIgnoreCase)) return i;
        }

        return -1;
    }
}
