using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Documents;

/// <summary>Trajectories as a job of a machine that has no splines: their curves become arcs and lines, and the run is judged by what the trajectories follow.</summary>
/// <param name="Job">Its table is the source of the trajectories, so that the judge knows nothing of the splines; its path is theirs.</param>
/// <param name="Trajectories">What is run, in this order.</param>
/// <param name="Bound">No place of the path is farther from the source than this, millimetres: the largest proven bound and what the arcs add.</param>
public sealed record TrajectoryJob(PreparedJob Job, IReadOnlyList<DocumentTrajectory> Trajectories, double Bound)
{
    /// <summary>Part of a count by which arcs may leave the spline.</summary>
    private const double CountShare = 0.25;

    /// <summary>The trajectories that stand beside the drawing; where none do, one for each run of each contour that is cut.</summary>
    /// <exception cref="SettingException">A named layer or the entering entity is not in the drawing.</exception>
    public static TrajectoryJob Prepare(Drawing drawing, DrawingSettings settings, MotionStyle style)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(settings);
        var (trajectories, findings) = Find(drawing, settings);
        return Prepare(drawing with { Diagnostics = [.. drawing.Diagnostics, .. findings] }, settings, trajectories, style);
    }

    /// <summary>The trajectories that stand beside the drawing; where none do, one for each run of each contour that is cut.</summary>
    /// <exception cref="SettingException">A named layer or the entering entity is not in the drawing.</exception>
    public static (IReadOnlyList<DocumentTrajectory> Trajectories, IReadOnlyList<Diagnostic> Findings) Find(Drawing drawing, DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(settings);
        var read = SidecarFile.Read(drawing);
        List<Diagnostic> findings = [.. read.Findings];
        return (read.Sidecar is { Trajectories.All: { Count: > 0 } kept } ? kept : Planned(drawing, settings, findings), findings);
    }

    /// <param name="trajectories">In the order in which they are run; the path from one to another is chosen by where they end.</param>
    public static TrajectoryJob Prepare(Drawing drawing, DrawingSettings settings, IReadOnlyList<DocumentTrajectory> trajectories, MotionStyle style)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(trajectories);
        var arcError = CountShare / settings.Machine.Scale.Largest;
        var own = settings with { MaxErrorMm = arcError, Layers = null, SkippedLayers = [], Enter = null, Order = StrokeOrder.Drawn, KeepDuplicates = true, RecoverArcs = false, Unit = null };
        var splines = TrajectorySheet.Of(drawing, [.. trajectories.Select(one => (IReadOnlyList<Segment>)[Segment.FromCurve(TrajectoryCurve.Of(one.Curve))])]);
        var table = JobPreparation.Analyse(splines, own);
        var sequence = JobPreparation.Sequence(splines, table, own);
        var job = JobPreparation.FromPath(splines, own, table, sequence, JobPreparation.PathOf(sequence, own), style);
        var bound = trajectories.Select(one => one.Curve.VerifiedBound).DefaultIfEmpty().Max() + arcError;
        var source = TrajectorySheet.Of(drawing, [.. trajectories.Select(one => one.Curve.Source)]);
        return new TrajectoryJob(job with { Analysed = JobPreparation.Analyse(source, own), Settings = own with { MaxErrorMm = bound } }, trajectories, bound);
    }

    private static List<DocumentTrajectory> Planned(Drawing drawing, DrawingSettings settings, List<Diagnostic> findings)
    {
        var made = new List<DocumentTrajectory>();
        foreach (var stroke in JobPreparation.Sequence(drawing, JobPreparation.Analyse(drawing, settings), settings).Strokes)
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
    /// <param name="like">File name, bytes, version and findings are taken from it.</param>
    /// <param name="groups">Each segment becomes an entity.</param>
    public static Drawing Of(Drawing like, IReadOnlyList<IReadOnlyList<Segment>> groups)
    {
        var (entities, parts, curves) = (new GrowingColumn<DrawingEntity>(), new GrowingColumn<DrawingPart>(), new List<RationalCurve>());
        foreach (var segment in groups.SelectMany(group => group))
        {
            var type = segment.Kind switch { SegmentKind.Line => CurveType.Line, SegmentKind.Circle => CurveType.Circle, SegmentKind.Arc => CurveType.Arc, SegmentKind.Ellipse => CurveType.Ellipse, _ => CurveType.Spline };
            entities.Add(new DrawingEntity { FirstPart = parts.Count, PartCount = 1, Type = type, Closed = segment.IsClosed });
            parts.Add(PartOf(segment, entities.Count - 1, curves));
        }

        return like with
        {
            Unit = LengthUnit.AssumedMillimetres with { Source = "option" },
            Layers = [new Layer("0", On: true, Frozen: false, Plot: true)],
            Entities = entities,
            Parts = parts,
            Curves = curves,
            Texts = [],
            Construction = [],
        };
    }

    private static DrawingPart PartOf(Segment segment, int entity, List<RationalCurve> curves)
    {
        if (segment.Kind == SegmentKind.Line) return DrawingPart.Line(entity, segment.Start.X, segment.Start.Y, 0.0, segment.End.X, segment.End.Y, 0.0);
        if (!segment.IsFreeCurve) return DrawingPart.Arc(entity, segment.Arc, 0.0);
        curves.Add(segment.Curve);
        return DrawingPart.FreeCurve(entity, segment.Kind, curves.Count - 1);
    }
}
