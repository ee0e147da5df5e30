using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Offsets;
using Engraver.Core.Pockets;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Commands.Trajectories;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Toolpaths;

/// <summary>POCKET: Clears the inside of closed objects; the strokes and the entry moves become polylines on the layer POCKET, in the order of cutting, and may
/// become the job.</summary>
internal sealed class PocketCommand : ICommand
{
    private const string Layer = "POCKET";

    public CommandInfo Info { get; } = new("POCKET", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await SelectedContours.TakeAsync(context).ConfigureAwait(false);
        IReadOnlyList<OffsetContour> contours = [.. selected.All.Select(one => one.Contour)];
        var (options, depths, isJob) = await new PocketPrompts(context, contours).AskAsync().ConfigureAwait(false);
        var drawing = context.Drawing;
        var result = PocketPlanner.Plan(contours, options);
        var cuts = result.Strokes.Count > 0 ? PocketLevels.Of(result, options, depths) : [];
        FindingMessages.Write(context, drawing.FileName, [.. PocketFindings.Of(result, options), .. PocketDrawing.Findings(cuts, depths)], Severity.Info);
        if (result is not { Strokes.Count: > 0, Coverage: { } coverage }) throw new CommandException(CommandFailure.Usage, Wording.Get("Pocket.NothingToClear"));
        cancellation.ThrowIfCancellationRequested();
        context.WriteMessage(Wording.Get("Pocket.Covered", 100.0 * coverage, result.ReachableArea, result.Passes.Count, result.Strokes.Count), MessageKind.Result);
        var hasOperations = context.Document.Current.Settings.Operations is not null;
        if (!hasOperations) OperationHint.Write(context, "Pocket.OperationsAreTheWay");
        if (isJob && hasOperations) context.WriteMessage(Wording.Get("Pocket.OperationsAreTheJob"));
        isJob &= !hasOperations;
        Commit(context, drawing, selected.Entities, cuts, isJob);
        if (isJob) context.WriteMessage(Wording.Get("Pocket.IsTheJob", Layer), MessageKind.Result);
        else context.WriteMessage(Wording.Get("Pocket.OutlinesStay"), MessageKind.Warning);
    }

    private static void Commit(CommandContext context, Drawing drawing, IReadOnlyList<int> selected, IReadOnlyList<PocketCut> cuts, bool isJob)
    {
        var layers = drawing.Layers.ToList();
        var layer = layers.FindIndex(known => known.Name.Equals(Layer, StringComparison.OrdinalIgnoreCase));
        if (layer < 0)
        {
            layer = layers.Count;
            layers.Add(new Layer(Layer, On: true, Frozen: false, Plot: true) { Colour = DrawingColour.FromCode62(4) });
        }

        var rebuilt = new DrawingRebuild(drawing with { Layers = layers });
        for (var index = 0; index < drawing.Entities.Count; index++) rebuilt.Keep(index);
        var like = drawing.Entities[selected[0]] with { Layer = layer, Colour = DrawingColour.ByLayer, Hidden = false };
        var (added, scale) = (new List<int>(), drawing.Scale.MapToDrawing);
        foreach (var cut in cuts)
        {
            if (cut.Path.Count > 1)
            {
                added.Add(rebuilt.Count);
                rebuilt.Add(like, CurveType.Polyline, closed: false, [.. cut.Path.Skip(1).Zip(cut.Path, (to, from) => DrawingPart.Line(0, from.Place.X, from.Place.Y, from.Z, to.Place.X, to.Place.Y, to.Z).Transformed(scale))]);
            }

            added.Add(rebuilt.Count);
            rebuilt.Add(like, CurveType.LwPolyline, cut.Stroke.Start == cut.Stroke.End, [.. PocketDrawing.SegmentsOf(cut.Stroke).Select(segment => PartOf(segment, cut.Z).Transformed(scale))]);
        }

        DrawingChange.Commit(context, rebuilt, added, settings => isJob ? settings with { Layers = [Layer], SkippedLayers = [], Order = StrokeOrder.Drawn, Enter = null, Kerf = KerfSide.Off } : settings);
    }

    private static DrawingPart PartOf(in Segment segment, double z) =>
        segment.Kind == SegmentKind.Line ? DrawingPart.Line(0, segment.Start.X, segment.Start.Y, z, segment.End.X, segment.End.Y, z) : DrawingPart.Arc(0, segment.Arc, z);
}
