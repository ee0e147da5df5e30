using System.Text.Json;
using Engraver.Core.Operations;

namespace Engraver.Workbench.Sidecars;

/// <summary>Data of a drawing that DXF cannot store: trajectories, and unknown members, which are preserved. Immutable.</summary>
/// <remarks>A new section is a property here with its reading and writing in <see cref="SidecarText"/>; until then it is preserved in
/// <see cref="UnknownMembers"/>.</remarks>
public sealed record Sidecar
{
    public static Sidecar Empty { get; } = new();

    public TrajectoryList Trajectories { get; init; } = TrajectoryList.Empty;

    /// <summary>The operations of the drawing; null for none.</summary>
    public OperationPlan? Operations { get; init; }

    /// <summary>Why the operations of the file are kept and not run; null if they are run, or if there are none.</summary>
    public string? WhyNotRun { get; init; }

    /// <summary>Members that this program does not use (pins, startPoints, operations that it cannot run), in the order of the file.</summary>
    public IReadOnlyList<KeyValuePair<string, JsonElement>> UnknownMembers { get; init; } = [];

    /// <summary>Minor version of the file if it is newer than this program; it is preserved.</summary>
    public int Minor { get; init; }

    /// <summary>True if there is nothing to save.</summary>
    public bool IsEmpty => Trajectories.All.Count == 0 && Operations is null && UnknownMembers.Count == 0;

    /// <summary>The same with other operations, which replace those that cannot be run.</summary>
    public Sidecar WithOperations(OperationPlan? operations) => this with { Operations = operations, WhyNotRun = null, UnknownMembers = [.. UnknownMembers.Where(member => member.Key != SidecarText.OperationsMember)] };

    /// <summary>True if both have the same file content.</summary>
    public bool IsSavedIn(Sidecar other) => (IsEmpty && other.IsEmpty) || this == other;
}
