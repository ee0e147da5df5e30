using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Verification;

namespace Engraver.Workbench.Sidecars;

/// <summary>Detects trajectories whose source entities have changed.</summary>
public sealed class TrajectoryEdits
{
    private readonly Drawing _drawing;
    private readonly Dictionary<string, List<int>> _entities = new(StringComparer.OrdinalIgnoreCase);

    public TrajectoryEdits(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        _drawing = drawing;
        for (var index = 0; index < drawing.Entities.Count; index++)
        {
            if (drawing.Entities[index].Handle is not 0 and var handle) Add(handle.ToString("X", CultureInfo.InvariantCulture), index);
        }
    }

    /// <summary>Entities with these handles, in the order of the drawing; null if a handle no longer exists. Entities of a block share one handle.</summary>
    public IReadOnlyList<int>? EntitiesOf(IReadOnlyList<string> handles)
    {
        ArgumentNullException.ThrowIfNull(handles);
        return handles.All(_entities.ContainsKey) ? [.. handles.SelectMany(handle => _entities[handle]).Distinct().Order()] : null;
    }

    /// <summary>Fingerprint of the entities with these handles in their current state; empty if one no longer exists or there are none.</summary>
    public string FingerprintOf(IReadOnlyList<string> handles) => EntitiesOf(handles) is { Count: > 0 } entities
        ? DrawnFingerprint.Of([.. entities.SelectMany(index => Enumerable.Range(_drawing.Entities[index].FirstPart, _drawing.Entities[index].PartCount)).Select(part => _drawing.SegmentOf(_drawing.Parts[part]))])
        : "";

    /// <summary>True if the source of the trajectory was moved, changed or erased.</summary>
    public bool IsStale(DocumentTrajectory one)
    {
        ArgumentNullException.ThrowIfNull(one);
        return one.Origin is { } origin && origin.SourceFingerprint != FingerprintOf(one.Handles);
    }

    /// <summary>A warning if trajectories no longer follow the drawing, which names the first one.</summary>
    public static IEnumerable<Diagnostic> Findings(Drawing drawing, IReadOnlyList<DocumentTrajectory> trajectories)
    {
        if (!trajectories.Any(one => one.Origin is not null)) yield break;
        var edits = new TrajectoryEdits(drawing);
        DocumentTrajectory[] stale = [.. trajectories.Where(edits.IsStale)];
        if (stale.Length > 0) yield return TrajectoryRules.SourceEdited.At(default, FactText.Of(stale.Length), stale[0].Name);
    }

    private void Add(string handle, int index)
    {
        if (_entities.TryGetValue(handle, out var known)) known.Add(index);
        else _entities[handle] = [index];
    }
}
