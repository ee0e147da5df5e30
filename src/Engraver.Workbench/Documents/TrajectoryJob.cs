using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Sidecars;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>Trajectories as a job for a machine without splines: their curves are converted to arcs and lines, and the run is compared with the source of the
/// trajectories.</summary>
/// <param name="Job">Its table is the source of the trajectories, so that verification is independent of the splines; its path follows the
/// trajectories.</param>
/// <param name="Trajectories">The trajectories in run order.</param>
/// <param name="Bound">Maximum distance of the path from the source, millimetres: the largest proven bound plus the error of the arcs.</param>
public sealed record TrajectoryJob(PreparedJob Job, IReadOnlyList<DocumentTrajectory> Trajectories, double Bound)
{
    /// <summary>Heights below this count as zero, millimetres.</summary>
    private const double NoHeight = 1e-6;

    /// <summary>Allowed error of the arcs relative to the spline, as a fraction of a count.</summary>
    private const double CountShare = 0.25;

    /// <summary>Uses the trajectories of the sidecar, otherwise creates one for each run of each cut contour.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static TrajectoryJob Prepare(Drawing drawing, DrawingSettings settings, MotionStyle style)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(settings);
        var (trajectories, findings) = Find(drawing, settings);
        return Prepare(drawing with { Diagnostics = [.. drawing.Diagnostics, .. findings] }, settings, trajectories, style);
    }

    /// <summary>The trajectories of the sidecar, otherwise one for each run of each cut contour.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static (IReadOnlyList<DocumentTrajectory> Trajectories, IReadOnlyList<Diagnostic> Findings) Find(Drawing drawing, DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(settings);
        var read = SidecarFile.Read(drawing);
        List<Diagnostic> findings = [.. read.Findings];
        if (!drawing.Placement.IsNone && read.Sidecar is { Trajectories.All.Count: > 0 }) throw new SettingException(Wording.Get("Trajectories.NotPlaced"));
        return (read.Sidecar is { Trajectories.All: { Count: > 0 } kept } ? kept : Planned(drawing, settings, findings), findings);
    }

    /// <param name="trajectories">In run order; the connecting moves depend on their end points.</param>
    public static TrajectoryJob Prepare(Drawing drawing, DrawingSettings settings, IReadOnlyList<DocumentTrajectory> trajectories, MotionStyle style)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(trajectories);
        var arcError = settings.Machine.Scale.Finer.LengthOf(CountShare);
        var rises = trajectories.Any(one => one.IsHelix);
        var own = settings with { MaxErrorMm = arcError, Layers = null, SkippedLayers = [], Enter = null, Order = StrokeOrder.Drawn, KeepDuplicates = true, RecoverArcs = false, FitArcs = false, Unit = null, Kerf = KerfSide.Off, Operations = null };
        if (rises) own = own with { JoinToleranceMm = Math.Min(own.JoinToleranceMm, StageOptions.ExactJoint) }; // A chord of a helix may be shorter than the join tolerance of a drawing.
        var splines = TrajectorySheet.Of(drawing, [.. trajectories.SelectMany(one => one.IsHelix ? TrajectoryChords.OfCurve(one.Curve, arcError) : [WithHeight(Segment.FromCurve(TrajectoryCurve.Of(one.Curve)), one.Curve.Z)]).Select(AtHeight)]);
        var job = JobPreparation.Prepare(splines, own, style);
        var bound = trajectories.Select(one => one.Curve.VerifiedBound).DefaultIfEmpty().Max() + (rises ? 2.0 * arcError : arcError);
        var source = TrajectorySheet.Of(drawing, [.. trajectories.SelectMany(one => one.IsHelix ? TrajectoryChords.OfSource(one.Curve, arcError) : one.Curve.Source.Select(segment => WithHeight(segment, one.Curve.Z))).Select(AtHeight)]);
        return new TrajectoryJob(
            job with
            {
                Analysed = JobPreparation.Analyse(source, own),
                Settings = own with { MaxErrorMm = bound },
                Findings = [.. job.Findings, .. PocketDrawing.OperationsRefused(settings, "trajectory"), .. Heights(trajectories, settings.Machine), .. TrajectoryEdits.Findings(drawing, trajectories), .. TrajectoryExport.ErrorsExceeded(trajectories)],
                Trajectories = new FollowedTrajectories(drawing, settings, trajectories),
            },
            trajectories,
            bound);

        RaisedSegment AtHeight(RaisedSegment raised) => settings.Machine.Height is null ? WithHeight(raised.Segment, 0.0) : raised;
    }

    /// <summary>A warning if there are heights but no tool axis.</summary>
    private static IEnumerable<Diagnostic> Heights(IReadOnlyList<DocumentTrajectory> trajectories, MachineProfile machine)
    {
        double[] heights = [.. trajectories.SelectMany(one => one.Curve.Heights?.Skip(1).SkipLast(1) ?? [one.Curve.Z])];
        if (machine.Height is not null || !Array.Exists(heights, z => Math.Abs(z) > NoHeight)) yield break;
        yield return TrajectoryRules.HeightsNotRun.At(default, FactText.Of(heights.Min()), FactText.Of(heights.Max()));
    }

    private static RaisedSegment WithHeight(Segment segment, double z) => new(segment, z, z);

    private static List<DocumentTrajectory> Planned(Drawing drawing, DrawingSettings settings, List<Diagnostic> findings)
    {
        var made = new List<DocumentTrajectory>();
        var ordered = JobPreparation.To<OrderedJob>(drawing, settings with { Operations = null });
        findings.AddRange([.. ordered.Findings, .. CheckStage.TextFaultsOf(ordered)]);
        if (CheckStage.TextFaultsOf(ordered).Count > 0) return made;
        findings.AddRange(ordered.Cut.Kerf?.Diagnostics ?? []);
        foreach (var stroke in ordered.Sequence.Strokes)
        {
            var planned = TrajectoryPlanner.Plan([.. stroke.Moves.Select(move => move.Segment)], stroke.Closed, new TrajectoryOptions(settings.MaxErrorMm));
            made.AddRange(planned.Trajectories.Select((one, i) => new DocumentTrajectory($"traj{made.Count + i}_path", one, settings.MaxErrorMm)));
            findings.AddRange(TrajectoryFindings.NotKept(planned.Unproven, settings.MaxErrorMm));
        }

        return made;
    }
}

/// <summary>Segments in millimetres as a drawing of one layer.</summary>
internal static class TrajectorySheet
{
    /// <param name="like">File name, bytes, version and findings are copied.</param>
    /// <param name="segments">Each becomes an entity at its height.</param>
    public static Drawing Of(Drawing like, IReadOnlyList<RaisedSegment> segments)
    {
        var (entities, parts, curves) = (new GrowingColumn<DrawingEntity>(), new GrowingColumn<DrawingPart>(), new List<RationalCurve>());
        foreach (var (segment, startZ, endZ) in segments)
        {
            var type = segment.Kind switch { SegmentKind.Line => CurveType.Line, SegmentKind.Circle => CurveType.Circle, SegmentKind.Arc => CurveType.Arc, SegmentKind.Ellipse => CurveType.Ellipse, _ => CurveType.Spline };
            entities.Add(new DrawingEntity { FirstPart = parts.Count, PartCount = 1, Type = type, Closed = segment.IsClosed });
            parts.Add(PartOf(new RaisedSegment(segment, startZ, endZ), entities.Count - 1, curves));
        }

        return like with
        {
            Unit = LengthUnit.AssumedMillimetres with { Source = LengthUnit.Chosen },
            Layers = [new Layer("0", On: true, Frozen: false, Plot: true)],
            Entities = entities,
            Parts = parts,
            Curves = curves,
            Texts = [],
            Construction = [],
        };
    }

    private static DrawingPart PartOf(in RaisedSegment raised, int entity, List<RationalCurve> curves)
    {
        var segment = raised.Segment;
        if (segment.Kind == SegmentKind.Line) return DrawingPart.Line(entity, segment.Start.X, segment.Start.Y, raised.StartZ, segment.End.X, segment.End.Y, raised.EndZ);
        if (!segment.IsFreeCurve) return DrawingPart.Arc(entity, segment.Arc, raised.StartZ);
        curves.Add(AtHeight(segment.Curve, raised.StartZ));
        return DrawingPart.FreeCurve(entity, segment.Kind, curves.Count - 1);
    }

    private static RationalCurve AtHeight(RationalCurve curve, double z) => curve.With([.. curve.Spans.ToArray().Select(span => AtHeight(span, z))]);

    private static BezierSpan AtHeight(BezierSpan span, double z)
    {
        var points = span.Homogeneous.ToArray();
        for (var i = 0; i < points.Length; i += BezierSpan.Stride) points[i + 2] = z * points[i + 3];
        return new BezierSpan(points);
    }
}
