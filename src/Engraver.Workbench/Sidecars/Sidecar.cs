using System.Text.Json;

namespace Engraver.Workbench.Sidecars;

/// <summary>What belongs to a drawing and has no place in a DXF file: trajectories, and members that are kept for whoever knows them. Immutable.</summary>
/// <remarks>A new section is a property here with its reading and writing in <see cref="SidecarText"/>; until then it is among <see cref="Others"/>, as
/// written.</remarks>
public sealed record Sidecar
{
    public static Sidecar Empty { get; } = new();

    public TrajectoryList Trajectories { get; init; } = TrajectoryList.Empty;

    /// <summary>Members that this program does not know or does not use yet (pins, startPoints, operations), in the order of the file.</summary>
    public IReadOnlyList<KeyValuePair<string, JsonElement>> Others { get; init; } = [];

    /// <summary>Of the version that the file had, if it is newer than ours; it is written again.</summary>
    public int Minor { get; init; }

    /// <summary>True when there is nothing that a file would have to keep.</summary>
    public bool IsEmpty => Trajectories.All.Count == 0 && Others.Count == 0;

    /// <summary>True when a file of the one says what a file of the other says.</summary>
    public bool IsKeptBy(Sidecar other) => (IsEmpty && other.IsEmpty) || this == other;
}
