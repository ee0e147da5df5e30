using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Files;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>PLINE: Draws one polyline of lines and arcs. Its width is not asked for: a tool cuts the line in the middle.</summary>
internal sealed class PolylineCommand : ICommand
{
    public CommandInfo Info { get; } = new("PLINE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        NewDrawing.EnsureOpen(context);
        var last = LastDrawn.In(context);
        var start = await context.AskAsync(new PointPrompt(Wording.Get("Pline.SpecifyStart")) { EnterEnds = last is not null }).ConfigureAwait(false) is Answer<Point2D>.Value { Result: var place } ? place : last!.Value.End;
        context.LastPoint = start;
        var (run, drawing, isArc) = (new PolylineDraft(start, last?.EndTangent ?? new Vector2D(1.0, 0.0)), new PiecewiseDrawing(context), false);
        while (!run.IsFinished)
        {
            isArc = await (isArc ? PolylineArcs.NextAsync(context, run) : LineAsync(context, run)).ConfigureAwait(false);
            drawing.Show(run.Segments.Count == 0 ? [] : [NewCurve.Polyline([.. run.Segments], run.IsClosed)]);
            context.LastPoint = run.End;
        }
    }

    /// <returns>True if the next segment is an arc.</returns>
    private static async Task<bool> LineAsync(CommandContext context, PolylineDraft run)
    {
        var prompt = ShapePrompts.Place("Drafting.SpecifyNext", run.End, run.Segments.Count > 1 ? ["Arc", "Close", "Length", "Undo"] : ["Arc", "Length", "Undo"]) with { EnterEnds = true };
        var (line, option) = await ShapePrompts.PlaceAsync(context, prompt, run.LineTo).ConfigureAwait(false);
        switch (option)
        {
            case null:
                run.Add(line[0]);
                break;
            case "Arc":
                return true;
            case "Length":
                (line, _) = await ShapePrompts.AmountAsync(context, ShapePrompts.Length(context, "Line.SpecifyLength", run.End), length => run.LineTo(run.End + (run.Direction * length))).ConfigureAwait(false);
                run.Add(line[0]);
                break;
            case "Close":
                run.Close(run.LineTo(run.Start));
                break;
            case "Undo":
                run.Undo(context);
                break;
            default:
                run.Finish();
                break;
        }

        return false;
    }
}
