using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Offsets;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>The offset of a drawing's contours, millimetres.</summary>
/// <param name="Result">Loops and deviation.</param>
/// <param name="Diagnostics">Findings of all stages.</param>
public sealed record OffsetDrawing(OffsetResult Result, IReadOnlyList<Diagnostic> Diagnostics)
{
    private const string Layer = "OFFSET";

    /// <param name="drawing">Its selected layers are chained to contours.</param>
    /// <param name="settings">Layers, units and tolerances.</param>
    /// <param name="distance">Millimetres, above 0.</param>
    /// <param name="side">See <see cref="OffsetSide"/>.</param>
    /// <param name="options">Join and tolerance.</param>
    /// <exception cref="SettingException">A named layer is not in the drawing.</exception>
    public static OffsetDrawing Create(Drawing drawing, DrawingSettings settings, double distance, OffsetSide side, OffsetOptions options)
    {
        var job = JobPreparation.To<ChainedJob>(drawing, settings with { Kerf = KerfSide.Off, Operations = null });
        var chained = job.Chained;
        var contours = ContoursOf(chained);
        var result = ContourOffset.Offset(contours, distance, side, options);
        return new OffsetDrawing(result, [.. drawing.Diagnostics, .. PocketDrawing.OperationsRefused(settings, "offset"), .. job.Findings, .. CheckStage.TextFaultsOf(job), .. chained.Diagnostics, .. Findings(result, contours.Count, distance)]);
    }

    /// <summary>The contours of a chained drawing, in drawing direction.</summary>
    public static IReadOnlyList<OffsetContour> ContoursOf(ChainedTable chained) => DrawnContours.From(chained);

    /// <summary>A closed run of lines and arcs is a closed polyline, a circle a circle.</summary>
    public DxfSheet ToSheet() => new([new DxfSheetLayer(Layer, 4)], [.. Result.Loops.SelectMany((loop, index) => EntitiesOf(loop, index + 1))]);

    private static IEnumerable<DxfSheetEntity> EntitiesOf(OffsetLoop loop, int number)
    {
        if (DxfPolylineWriter.CanWrite(loop.Segments, loop.Closed)) return [new DxfSheetEntity(loop.Segments[0], Layer, null, 0, number) { Run = loop.Segments, Closed = loop.Closed }];
        if (loop.Segments is [{ Kind: SegmentKind.Circle, Arc: var circle }]) return [new DxfSheetEntity(Segment.FromArc(circle with { Start = Angle.Zero, Sweep = Angle.FullTurn }), Layer, null, 0, number)];
        return loop.Segments.Select(segment => new DxfSheetEntity(segment, Layer, null, 0, number));
    }

    /// <summary>The findings of an offset.</summary>
    internal static IEnumerable<Diagnostic> Findings(OffsetResult result, int contours, double distance)
    {
        if (result.WithoutInside > 0) yield return result.WithoutInside == contours ? OffsetRules.NoInside.At(default) : OffsetRules.WithoutInside.At(default, FactText.Of(result.WithoutInside));
        if (result.Unresolved is [var place, ..]) yield return OffsetRules.NotClosed.At(default, FactText.Of(place.X), FactText.Of(place.Y), FactText.Of(result.Unresolved.Count));
        if (result.Loops.Count == 0 && contours > result.WithoutInside) yield return OffsetRules.NothingLeft.At(default, FactText.Of(distance));
    }
}
