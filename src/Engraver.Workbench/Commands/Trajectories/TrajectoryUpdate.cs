using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Offsets;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>Recomputes trajectories from the current state of their source objects.</summary>
internal sealed class TrajectoryUpdate(Drawing drawing, DocumentState state, TrajectoryEdits edits)
{
    private readonly List<Diagnostic> _findings = [];

    /// <summary>Trajectories that could not be computed within their error.</summary>
    public IReadOnlyList<Diagnostic> Findings => _findings;

    /// <summary>The number in the name of the next trajectory.</summary>
    public int NextNumber { get; private set; } = state.Sidecar.Trajectories.NextNumber;

    /// <param name="group">The remaining trajectories of one group.</param>
    /// <returns>The trajectories in their order; empty if their objects were erased or the offset vanishes.</returns>
    public IReadOnlyList<DocumentTrajectory> Rebuild(IReadOnlyList<DocumentTrajectory> group)
    {
        var (first, origin) = (group[0], group[0].Origin!);
        if (edits.EntitiesOf(first.Handles) is not { Count: > 0 } entities) return [];
        IReadOnlyList<OffsetContour> contours = [.. SelectedContours.Of(drawing, state.Settings, entities).Contours.All.Select(one => one.Contour)];
        if (origin.Offset is { } distance) contours = OffsetContours(contours, distance, origin.Side, first.MaxErrorMm);
        var runs = contours.SelectMany(contour => Planned(contour.Segments, contour.Closed, first, origin.Corners)).ToList();
        var place = new TrajectoryOrigin(origin.Group, 0, runs.Count, edits.FingerprintOf(first.Handles)) { Offset = origin.Offset, Side = origin.Side, Corners = origin.Corners };
        return runs.Count == origin.Count ? [.. group.SelectMany(one => Fitted(one, first, runs[one.Origin!.Index], place))] : Others(group, runs, place);
    }

    /// <summary>The number of runs is unchanged: each trajectory gets the run of its number; deleted ones stay deleted.</summary>
    /// <param name="first">Trajectory whose error and steps were used to plan the run; it is planned again for trajectories with other values.</param>
    private IEnumerable<DocumentTrajectory> Fitted(DocumentTrajectory one, DocumentTrajectory first, Trajectory run, TrajectoryOrigin place)
    {
        var isAsFirst = (one.MaxErrorMm, one.SegmentLengthMm) == (first.MaxErrorMm, first.SegmentLengthMm);
        var own = isAsFirst ? [run] : Planned(run.Source, run.Closed, one, CornerMode.Continuous);
        return own.Take(1).Select(curve => one with { Curve = curve.Moved(one.Curve.Z), Origin = place with { Index = one.Origin!.Index } });
    }

    /// <summary>The number of runs has changed: creates all runs at each height, with the old names as far as possible.</summary>
    private List<DocumentTrajectory> Others(IReadOnlyList<DocumentTrajectory> group, List<Trajectory> runs, TrajectoryOrigin place)
    {
        var made = new List<DocumentTrajectory>();
        foreach (var z in group.Select(one => one.Curve.Z).Distinct())
        {
            for (var run = 0; run < runs.Count; run++)
            {
                var like = made.Count < group.Count ? group[made.Count] : group[0] with { Name = $"traj{NextNumber++}_{(place.Offset is null ? "path" : "offset")}", Others = [] };
                made.Add(like with { Curve = runs[run].Moved(z), MaxErrorMm = group[0].MaxErrorMm, SegmentLengthMm = group[0].SegmentLengthMm, Origin = place with { Index = run } });
            }
        }

        return made;
    }

    private IReadOnlyList<OffsetContour> OffsetContours(IReadOnlyList<OffsetContour> contours, double distance, OffsetSide side, double maxError)
    {
        var result = ContourOffset.Offset(contours, distance, side, OffsetOptions.Round(maxError));
        _findings.AddRange(OffsetDrawing.Findings(result, contours.Count, distance));
        return [.. result.Loops.Select(loop => new OffsetContour(loop.Segments, loop.Closed))];
    }

    private IReadOnlyList<Trajectory> Planned(IReadOnlyList<Core.Geometry.Segment> segments, bool closed, DocumentTrajectory like, CornerMode corners)
    {
        var planned = TrajectoryPlanner.Plan(segments, closed, new TrajectoryOptions(like.MaxErrorMm) { SegmentLength = like.SegmentLengthMm, Corners = corners });
        _findings.AddRange(TrajectoryFindings.NotKept(planned.Unproven, like.MaxErrorMm));
        return planned.Trajectories;
    }
}
