using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>OFFSET: Draws offset copies of objects at a distance or through a point, as lines and arcs.</summary>
internal sealed class OffsetCommand : ICommand
{
    private const string Last = "OFFSETDIST";
    private const double MinDistance = 1e-9;
    private const double MaxDistance = 1e9;

    public CommandInfo Info { get; } = new("OFFSET", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var choice = await ChoiceAsync(context).ConfigureAwait(false);
        int[] made = [0];
        int? found = null;
        var prompt = new PointPrompt(Wording.Get("Offset.SelectObject")) { Purpose = PointPurpose.Object, Validate = at => (found = ObjectSelection.EntityAt(context, at)) is null ? Wording.Get("Offset.NoObjectAtPoint") : null };
        while (await AnswerAsync(context, prompt, made).ConfigureAwait(false) is not null)
        {
            if (!await OffsetAsync(context, choice, found!.Value, made).ConfigureAwait(false)) return;
            context.HighlightPicked(null);
        }
    }

    /// <summary>Offsets one object to one side; with Multiple repeatedly the last result, until Enter.</summary>
    /// <returns>False if the operator ends the command.</returns>
    private static async Task<bool> OffsetAsync(CommandContext context, OffsetChoice choice, int entity, int[] made)
    {
        var (sources, isMultiple) = (new Stack<int>([entity]), false);
        while (true)
        {
            context.HighlightPicked([sources.Peek()]);
            var prompt = SidePrompt(context, choice, sources.Peek(), isMultiple);
            switch (await context.AskAsync(prompt).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Result: var side }:
                    if (Commit(context, choice, sources.Peek(), side) is { } next)
                    {
                        made[0]++;
                        sources.Push(next);
                    }

                    if (!isMultiple) return true;
                    break;
                case Answer<Point2D>.SelectedOption { Option: "Multiple" }:
                    isMultiple = true;
                    break;
                case Answer<Point2D>.SelectedOption { Option: "Undo" }:
                    if (!Undo(context, made)) break;
                    if (sources.Count == 1) return true; // The object may have another index now.
                    sources.Pop();
                    break;
                case Answer<Point2D>.EndOfList:
                    return true;
                default:
                    return false;
            }
        }
    }

    /// <summary>The distance and the treatment of the source.</summary>
    private static async Task<OffsetChoice> ChoiceAsync(CommandContext context)
    {
        var (erases, layer) = (false, default(int?));
        var first = new AmountPrompt(Wording.Get("Offset.SpecifyDistance"), way => way.Length) { Min = MinDistance, Max = MaxDistance, Options = Keyword.List("Through", "Erase", "Layer"), Default = context.LastValue(Last, "Through") };
        for (var prompt = first; ;)
        {
            switch (await context.AskAsync(prompt).ConfigureAwait(false))
            {
                case Answer<Amount>.Value { Result: Amount.Number { Value: var distance } }:
                    context.Remember(Last, distance.ToString("R", CultureInfo.InvariantCulture));
                    return new OffsetChoice(distance, erases, layer);
                case Answer<Amount>.Value { Result: Amount.FirstPoint { Point: var place } }:
                    prompt = first with { Instruction = Wording.Get("Common.SpecifySecondPoint"), Options = [], Default = null, From = place };
                    break;
                case Answer<Amount>.SelectedOption { Option: "Erase" }:
                    erases = await context.ConfirmAsync(Wording.Get("Offset.EraseSource")).ConfigureAwait(false);
                    break;
                case Answer<Amount>.SelectedOption { Option: "Layer" }:
                    layer = await LayerAsync(context).ConfigureAwait(false);
                    break;
                default:
                    context.Remember(Last, "Through");
                    return new OffsetChoice(null, erases, layer);
            }
        }
    }

    /// <returns>Null: that of the source.</returns>
    private static async Task<int?> LayerAsync(CommandContext context)
    {
        var prompt = new TextPrompt(Wording.Get("Offset.EnterLayer"))
        {
            Options = Keyword.List("Source"),
            Default = "Source",
            Validate = name => CurrentLayer.IndexOf(context.Drawing, name) is null ? Wording.Get("Offset.NoLayer", name) : null,
        };
        return await context.AskAsync(prompt).ConfigureAwait(false) is Answer<string>.Value { Result: var chosen } ? CurrentLayer.IndexOf(context.Drawing, chosen) : null;
    }

    private static PointPrompt SidePrompt(CommandContext context, OffsetChoice choice, int entity, bool isMultiple)
    {
        var (drawing, maxError) = (context.Drawing, context.Document.Current.Settings.MaxErrorMm);
        return new PointPrompt(Wording.Get(choice.Distance is null ? "Offset.SpecifyThroughPoint" : "Offset.SpecifySide"))
        {
            Options = isMultiple ? Keyword.List("Exit", "Undo") : Keyword.List("Exit", "Multiple", "Undo"),
            Default = isMultiple ? null : "Exit",
            EnterEnds = isMultiple,
            Ghost = place => [.. EntityOffset.Create(drawing, entity, place, choice.Distance, maxError).SelectMany(loop => loop.Segments)],
        };
    }

    /// <summary>A point; null if the operator ends the command. Undo reverts the results of this command one by one.</summary>
    private static async Task<Point2D?> AnswerAsync(CommandContext context, PointPrompt prompt, int[] made)
    {
        while (true)
        {
            switch (await context.AskAsync(prompt with { Options = Keyword.List("Exit", "Undo"), Default = "Exit" }).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Result: var place }:
                    return place;
                case Answer<Point2D>.SelectedOption { Option: "Undo" }:
                    Undo(context, made);
                    break;
                default:
                    return null;
            }
        }
    }

    /// <returns>False if there is nothing left to undo.</returns>
    private static bool Undo(CommandContext context, int[] made)
    {
        if (made[0] == 0)
        {
            context.WriteMessage(Wording.Get("Offset.NothingToUndo"));
            return false;
        }

        made[0]--;
        context.Document.Undo();
        return true;
    }

    /// <returns>Index of the result, of several loops the one nearest to the point; null if the result is empty.</returns>
    private static int? Commit(CommandContext context, OffsetChoice choice, int entity, Point2D side)
    {
        var drawing = context.Drawing;
        var loops = EntityOffset.Create(drawing, entity, side, choice.Distance, context.Document.Current.Settings.MaxErrorMm);
        if (loops.Count == 0)
        {
            context.WriteMessage(Wording.Get("Offset.NothingLeft"), MessageKind.Warning);
            return null;
        }

        var rebuilt = new DrawingRebuild(drawing);
        for (var index = 0; index < drawing.Entities.Count; index++)
        {
            if (!choice.ErasesSource || index != entity) rebuilt.Keep(index);
        }

        var first = rebuilt.Count;
        EntityOffset.Add(rebuilt, drawing, entity, loops, choice.Layer);
        DrawingChange.Commit(context, rebuilt, [.. Enumerable.Range(first, loops.Count)]);
        return first + Enumerable.Range(0, loops.Count).MinBy(loop => loops[loop].Segments.Min(segment => SegmentDistance.Measure(segment, side)));
    }

    /// <param name="Distance">Drawing units; null: through a point.</param>
    /// <param name="ErasesSource">The source is erased.</param>
    /// <param name="Layer">Index of the layer of the result; null for that of the source.</param>
    private sealed record OffsetChoice(double? Distance, bool ErasesSource, int? Layer);
}
