using System.Text.Json;

namespace Engraver.Workbench.Sidecars;

/// <summary>Data of a drawing that DXF cannot store: trajectories, and unknown members, which are preserved. Immutable.</summary>
/// <remarks>A new section is a property here with its reading and writing in <see cref="SidecarText"/>; until then it is preserved in
/// <see cref="UnknownMembers"/>.</remarks>
public sealed record Sidecar
{
    public static Sidecar Empty { get; } = new();

    public TrajectoryList Trajectories { get; init; } = TrajectoryList.Empty;

    /// <summary>Members that this program does not use (pins, startPoints, operations), in the order of the file.</summary>
    public IReadOnlyList<KeyValuePair<string, JsonElement>> UnknownMembers { get; init; } = [];

    /// <summary>Minor version of the file if it is newer than this program; it is preserved.</summary>
    public int Minor { get; init; }

    /// <summary>True if there is nothing to save.</summary>
    public bool IsEmpty => Trajectories.All.Count == 0 && UnknownMembers.Count == 0;

    /// <summary>True if both have the same file content.</summary>
    public bool IsSavedIn(Sidecar other) => (IsEmpty && other.IsEmpty) || this == other;
}
