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
        DrawingBeginning.Ensure(context);
        var last = LastDrawn.In(context);
        var start = await context.AskAsync(new PointPrompt(Wording.Get("Pline.SpecifyStart")) { EnterEnds = last is not null }).ConfigureAwait(false) is Answer<Point2D>.Value { Of: var place } ? place : last!.Value.End;
        context.LastPoint = start;
        var (run, drawing, isArc) = (new PolylineRun(start, last?.EndTangent ?? new Vector2D(1.0, 0.0)), new PiecewiseDrawing(context), false);
        while (!run.IsOver)
        {
            isArc = await (isArc ? PolylineArcs.NextAsync(context, run) : LineAsync(context, run)).ConfigureAwait(false);
            drawing.Show(run.Segments.Count == 0 ? [] : [NewCurve.Polyline([.. run.Segments], run.IsClosed)]);
            context.LastPoint = run.End;
        }
    }

    /// <returns>True if the next segment is an arc.</returns>
    private static async Task<bool> LineAsync(CommandContext context, PolylineRun run)
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
                run.Stop();
                break;
        }

        return false;
    }
}

/// <summary>The polyline being drawn.</summary>
/// <param name="start">Its first point.</param>
/// <param name="direction">Initial direction before the first segment; length 1.</param>
internal sealed class PolylineRun(Point2D start, Vector2D direction)
{
    private readonly List<Segment> _segments = [];

    public IReadOnlyList<Segment> Segments => _segments;

    public Point2D Start => start;

    public Point2D End => _segments.Count == 0 ? start : _segments[^1].End;

    /// <summary>Direction at the end; length 1.</summary>
    public Vector2D Direction => _segments.Count == 0 ? direction : _segments[^1].EndTangent;

    public bool IsClosed { get; private set; }

    /// <summary>The polyline is finished.</summary>
    public bool IsOver { get; private set; }

    /// <summary>A line from the end point; null if it has no length.</summary>
    public IReadOnlyList<Segment>? LineTo(Point2D place) => place == End ? null : [Segment.FromLine(End, place)];

    public void Add(Segment segment) => _segments.Add(segment);

    /// <param name="last">Segment from the end to the start; null if they coincide.</param>
    public void Close(IReadOnlyList<Segment>? last)
    {
        if (last is not null) _segments.Add(last[0]);
        (IsClosed, IsOver) = (true, true);
    }

    public void Stop() => IsOver = true;

    public void Undo(CommandContext context)
    {
        if (_segments.Count == 0) context.Say(Wording.Get("Drafting.NothingToUndo"));
        else _segments.RemoveAt(_segments.Count - 1);
    }
}
