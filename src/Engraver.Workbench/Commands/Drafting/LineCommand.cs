using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Files;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>LINE: Draws straight lines from point to point. Enter at the first prompt continues from the last line, or tangentially from the last
/// arc.</summary>
internal sealed class LineCommand : ICommand
{
    public CommandInfo Info { get; } = new("LINE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        NewDrawing.EnsureOpen(context);
        if (await FirstAsync(context).ConfigureAwait(false) is not { } points) return;
        var drawing = new PiecewiseDrawing(context);
        drawing.Show(Lines(points));
        while (await NextAsync(context, points).ConfigureAwait(false) is var next && next != LineStep.Stop)
        {
            drawing.Show(Lines(points));
            if (next == LineStep.Close) return;
        }
    }

    /// <returns>The first point; with the second if the line continues an arc; null if there is nothing to continue.</returns>
    private static async Task<List<Point2D>?> FirstAsync(CommandContext context)
    {
        if (await context.AskAsync(new PointPrompt(Wording.Get("Line.SpecifyFirst")) { EnterEnds = true }).ConfigureAwait(false) is Answer<Point2D>.Value { Result: var first }) return [first];
        if (LastDrawn.In(context) is not { } last)
        {
            context.WriteMessage(Wording.Get("Drafting.NothingToContinue"));
            return null;
        }

        context.LastPoint = last.End;
        if (last.Kind == SegmentKind.Line) return [last.End];
        var (line, _) = await ShapePrompts.AmountAsync(context, ShapePrompts.Length(context, "Line.SpecifyLength", last.End), length => [Segment.FromLine(last.End, last.End + (last.EndTangent * length))]).ConfigureAwait(false);
        context.LastPoint = line[0].End;
        return [last.End, line[0].End];
    }

    private static List<NewCurve> Lines(List<Point2D> points) => [.. points.Zip(points.Skip(1), Segment.FromLine).Where(line => line.Start != line.End).Select(NewCurve.From)];

    private static async Task<LineStep> NextAsync(CommandContext context, List<Point2D> points)
    {
        var from = points[^1];
        string[] options = points.Count > 2 ? ["Close", "Undo"] : ["Undo"];
        var prompt = ShapePrompts.Place("Drafting.SpecifyNext", from, options) with { EnterEnds = true };
        var (line, option) = await ShapePrompts.PlaceAsync(context, prompt, place => place == from ? null : [Segment.FromLine(from, place)]).ConfigureAwait(false);
        switch (option)
        {
            case null:
                points.Add(line[0].End);
                return LineStep.Continue;
            case "Undo":
                Undo(context, points);
                return LineStep.Continue;
            case "Close":
                points.Add(points[0]);
                return LineStep.Close;
            default:
                return LineStep.Stop;
        }
    }

    private static void Undo(CommandContext context, List<Point2D> points)
    {
        if (points.Count == 1) context.WriteMessage(Wording.Get("Drafting.NothingToUndo"));
        else points.RemoveAt(points.Count - 1);
        context.LastPoint = points[^1];
    }

    private enum LineStep
    {
        Continue,
        Close,
        Stop,
    }
}
