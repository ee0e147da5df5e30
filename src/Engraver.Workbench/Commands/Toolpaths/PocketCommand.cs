using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Pockets;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Commands.Trajectories;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Toolpaths;

/// <summary>POCKET: Clears what closed objects enclose; the strokes become polylines on the layer POCKET.</summary>
internal sealed class PocketCommand : ICommand
{
    private const string Layer = "POCKET";

    public CommandInfo Info { get; } = new("POCKET", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await SelectedContours.TakeAsync(context).ConfigureAwait(false);
        var (options, depths) = await AskAsync(context).ConfigureAwait(false);
        var drawing = context.Drawing;
        var result = PocketPlanner.Plan([.. selected.All.Select(one => one.Contour)], options with { MaxErrorMm = context.Document.Current.Settings.MaxErrorMm });
        FindingMessages.Say(context, drawing.FileName, PocketDrawing.Findings(result, options), Severity.Info);
        if (result is not { Strokes.Count: > 0, Coverage: { } coverage }) throw new CommandException(CommandFailure.Usage, Wording.Get("Pocket.NothingToClear"));
        cancellation.ThrowIfCancellationRequested();
        context.Say(Wording.Get("Pocket.Covered", 100.0 * coverage, result.ReachableArea, result.Passes.Count, result.Strokes.Count), MessageKind.Result);
        Take(context, drawing, selected.Entities, PocketLevels.Of(result, options, depths));
        context.Say(Wording.Get("Pocket.OutlinesStay"), MessageKind.Warning);
    }

    private static async Task<(PocketOptions Options, PocketDepths Depths)> AskAsync(CommandContext context)
    {
        var diameter = await NumberAsync(context, "Diameter", "1", 1e-3, 1e3).ConfigureAwait(false);
        var overlap = await NumberAsync(context, "Overlap", "0.5", 0.01, 0.99).ConfigureAwait(false);
        var strategy = await context.ChoiceAsync(Wording.Get("Pocket.Strategy"), Keyword.List("Contour", "Zigzag"), context.Remembered("POCKET.Strategy", "Contour")).ConfigureAwait(false);
        context.Remember("POCKET.Strategy", strategy);
        var angle = strategy == "Zigzag" ? await NumberAsync(context, "Angle", "0", -360, 360).ConfigureAwait(false) : 0.0;
        var depth = await NumberAsync(context, "Depth", "0", 0, 1e3).ConfigureAwait(false);
        var step = depth > 0.0 ? await NumberAsync(context, "Step", NumberPrompt.Show(depth), 1e-3, 1e3).ConfigureAwait(false) : 0.0;
        var options = new PocketOptions { ToolRadius = diameter / 2.0, Overlap = overlap, Strategy = Enum.Parse<PocketStrategy>(strategy), Angle = Angle.FromDegrees(angle) };
        return (options, new PocketDepths { Depth = depth, Step = step });
    }

    private static async Task<double> NumberAsync(CommandContext context, string name, string first, double least, double most)
    {
        var value = await context.ValueAsync(new NumberPrompt(Wording.Get("Pocket." + name)) { Default = context.Remembered("POCKET." + name, first), Least = least, Most = most }).ConfigureAwait(false);
        context.Remember("POCKET." + name, NumberPrompt.Show(value));
        return value;
    }

    private static void Take(CommandContext context, Drawing drawing, IReadOnlyList<int> selected, IReadOnlyList<PocketCut> cuts)
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
        var (added, scale) = (new List<int>(), Transform2D.ScaleFrom(Point2D.Origin, 1.0 / drawing.Unit.ToMillimetres));
        foreach (var cut in cuts)
        {
            added.Add(rebuilt.Count);
            rebuilt.Add(like, CurveType.LwPolyline, cut.Stroke.Start == cut.Stroke.End, [.. PocketDrawing.SegmentsOf(cut.Stroke).Select(segment => PartOf(segment, cut.Z).Transformed(scale))]);
        }

        DrawingChange.Take(context, rebuilt, added);
    }

    private static DrawingPart PartOf(in Segment segment, double z) =>
        segment.Kind == SegmentKind.Line ? DrawingPart.Line(0, segment.Start.X, segment.Start.Y, z, segment.End.X, segment.End.Y, z) : DrawingPart.Arc(0, segment.Arc, z);
}
