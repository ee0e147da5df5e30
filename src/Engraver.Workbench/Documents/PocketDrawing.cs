using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Pockets;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>The pockets of a drawing, millimetres.</summary>
/// <param name="Result">Passes, strokes, areas.</param>
/// <param name="Cuts">The strokes at their depths, in the order of cutting.</param>
/// <param name="Diagnostics">Findings of all stages.</param>
public sealed record PocketDrawing(PocketResult Result, IReadOnlyList<PocketCut> Cuts, IReadOnlyList<Diagnostic> Diagnostics)
{
    private const string Layer = "POCKET";

    /// <param name="drawing">Its selected layers are chained to contours.</param>
    /// <param name="settings">Layers, units and tolerances.</param>
    /// <param name="options">Tool, strategy and tolerances.</param>
    /// <param name="depths">Levels and entry.</param>
    /// <exception cref="SettingException">A named layer is not in the drawing.</exception>
    public static PocketDrawing Create(Drawing drawing, DrawingSettings settings, PocketOptions options, PocketDepths depths)
    {
        var job = JobPreparation.To<ChainedJob>(drawing, settings with { Kerf = KerfSide.Off, Operations = null });
        var chained = job.Chained;
        var result = PocketPlanner.Plan(OffsetDrawing.ContoursOf(chained), options);
        var cuts = PocketLevels.Of(result, options, depths);
        return new PocketDrawing(result, cuts, [.. drawing.Diagnostics, .. OperationsRefused(settings, "pocket"), .. job.Findings, .. CheckStage.TextFaultsOf(job), .. chained.Diagnostics, .. DrawingFile.IsUnreadable(drawing) ? [] : PocketFindings.Of(result, options), .. Findings(cuts, depths)]);
    }

    /// <summary>The error for a result that is made from the drawing alone, if operations are requested for it.</summary>
    internal static IEnumerable<Diagnostic> OperationsRefused(DrawingSettings settings, string target) => settings.Operations is null ? [] : [OperationRules.NotPosted.At(default, target, Wording.Get("PostedProgram.WithoutOperations"))];

    /// <summary>Every stroke as a polyline at its height, preceded by its entry move as a 3D polyline; in the order of cutting.</summary>
    public DxfSheet ToSheet() => new([new DxfSheetLayer(Layer, 4)], [.. Cuts.SelectMany((cut, index) => EntitiesOf(cut, index + 1))]);

    private static IEnumerable<DxfSheetEntity> EntitiesOf(PocketCut cut, int number)
    {
        if (cut.Path.Count > 1)
        {
            var lines = cut.Path.Skip(1).Zip(cut.Path, (to, from) => Segment.FromLine(from.Place, to.Place)).ToList();
            yield return new DxfSheetEntity(lines[0], Layer, null, 0, number) { Run = lines, Heights = [.. cut.Path.Select(point => point.Z)] };
        }

        var segments = SegmentsOf(cut.Stroke);
        var closed = segments.Count > 1 && segments[^1].End == segments[0].Start;
        if (DxfPolylineWriter.CanWrite(segments, closed))
        {
            yield return new DxfSheetEntity(segments[0], Layer, null, 0, number) { Run = segments, Closed = closed, Z = (cut.Z, cut.Z) };
            yield break;
        }

        foreach (var segment in segments) yield return new DxfSheetEntity(segment, Layer, null, 0, number) { Z = (cut.Z, cut.Z) };
    }

    /// <summary>Lines, and arcs of at most half a turn, as required in a polyline.</summary>
    internal static List<Segment> SegmentsOf(PocketStroke stroke)
    {
        var segments = new List<Segment>(stroke.Moves.Count);
        foreach (var segment in stroke.Moves.Select(move => move.Segment))
        {
            if (segment.Kind == SegmentKind.Line || Math.Abs(segment.Arc.Sweep.Degrees) <= 180.0)
            {
                segments.Add(segment);
                continue;
            }

            var (arc, middle) = (segment.Arc, segment.PointAt(0.5));
            segments.Add(Segment.FromArc(arc with { Sweep = arc.Sweep * 0.5 }, segment.Start, middle));
            segments.Add(Segment.FromArc(arc with { Start = arc.Start + (arc.Sweep * 0.5), Sweep = arc.Sweep * 0.5 }, middle, segment.End));
        }

        return segments;
    }

    /// <summary>The findings of the entry moves.</summary>
    internal static IEnumerable<Diagnostic> Findings(IReadOnlyList<PocketCut> cuts, PocketDepths depths)
    {
        if (depths.Entry == PocketEntry.Plunge) yield break;
        List<PocketCut> plunges = [.. cuts.Where(cut => cut.Entry == PocketEntry.Plunge)];
        if (plunges is [var straight, ..]) yield return PocketRules.NoRoomForRamp.At(default, FactText.Of(plunges.Count), FactText.Of(straight.Stroke.Start.X), FactText.Of(straight.Stroke.Start.Y)) with { Place = straight.Stroke.Start };
        if (depths.Entry != PocketEntry.Helix) yield break;
        List<PocketCut> ramps = [.. cuts.Where(cut => cut.Entry == PocketEntry.Ramp)];
        if (ramps is [var first, ..]) yield return PocketRules.NoRoomForScrew.At(default, FactText.Of(ramps.Count), FactText.Of(first.Stroke.Start.X), FactText.Of(first.Stroke.Start.Y)) with { Place = first.Stroke.Start };
    }
}
