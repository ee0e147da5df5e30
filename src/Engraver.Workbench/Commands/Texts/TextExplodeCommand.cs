using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Commands.Texts;

/// <summary>TXTEXP: Replaces texts by the curves of their letters, on their layers and in their colours.</summary>
internal sealed class TextExplodeCommand : ICommand
{
    public CommandInfo Info { get; } = new("TXTEXP", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetForEditAsync(context, takesTexts: true).ConfigureAwait(false);
        var (drawing, shown) = (context.Drawing, ShownDrawing.Of(context.Drawing));
        int[] texts = [.. selected.Where(index => ShownDrawing.TextOf(drawing, index) is not null && shown.Entities[index].PartCount > 0)];
        if (texts.Length == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("TxtExp.NoText"));
        var rebuilt = new DrawingRebuild(drawing);
        for (var index = 0; index < drawing.Entities.Count; index++) rebuilt.Keep(index);
        foreach (var text in texts) Add(rebuilt, shown, text);
        var gone = texts.Select(index => index - drawing.Entities.Count).ToHashSet();
        var previous = Enumerable.Range(drawing.Entities.Count, rebuilt.Count - drawing.Entities.Count).ToList();
        var edited = rebuilt.Finish();
        DrawingChange.Commit(context, edited with { Texts = [.. drawing.Texts.Where((_, index) => !gone.Contains(index))] }, previous);
        context.WriteMessage(Wording.Get("Editing.Converted", CountText.Format(texts.Length, "Text"), CountText.Format(previous.Count, "Object")));
    }

    /// <summary>Connected lines and arcs become a polyline, an ellipse or a spline an object of its own.</summary>
    private static void Add(DrawingRebuild rebuilt, Drawing shown, int text)
    {
        var (like, run) = (shown.Entities[text], new List<DrawingPart>());
        foreach (var part in DrawingRebuild.PartsOf(shown, text))
        {
            if (run.Count > 0 && (part.IsFreeCurve || shown.SegmentOf(part).Start != shown.SegmentOf(run[^1]).End)) End();
            if (!part.IsFreeCurve && part.Kind != SegmentKind.Circle) run.Add(part);
            else rebuilt.Add(like, PolylineEdit.TypeOf(part), closed: part.Kind == SegmentKind.Circle, [part.IsFreeCurve ? rebuilt.PartOf(shown.Curves[part.CurveIndex]) : part]);
        }

        if (run.Count > 0) End();

        void End()
        {
            var (first, last) = (shown.SegmentOf(run[0]), shown.SegmentOf(run[^1]));
            var isOne = run.Count == 1;
            rebuilt.Add(like, isOne ? PolylineEdit.TypeOf(run[0]) : CurveType.LwPolyline, closed: !isOne && last.End == first.Start, run);
            run.Clear();
        }
    }
}
