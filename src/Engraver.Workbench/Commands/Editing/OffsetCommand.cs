using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>OFFSET: Draws objects again at a distance or through a point, as lines and arcs.</summary>
internal sealed class OffsetCommand : ICommand
{
    private const string Last = "OFFSETDIST";
    private const double LeastDistance = 1e-9;
    private const double LargestDistance = 1e9;

    public CommandInfo Info { get; } = new("OFFSET", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var choice = await ChoiceAsync(context).ConfigureAwait(false);
        int[] made = [0];
        while (await AnswerAsync(context, new PointPrompt(Wording.Get("Offset.SelectObject")) { Use = PointUse.Object }, made).ConfigureAwait(false) is { } at)
        {
            if (ObjectSelection.At(context, at) is not { } entity) context.Say(Wording.Get("Offset.NoObject"));
            else if (await AnswerAsync(context, SidePrompt(context, choice, entity), made).ConfigureAwait(false) is not { } side) return;
            else if (Take(context, choice, entity, side)) made[0]++;
        }
    }

    /// <summary>The distance, and what becomes of the source.</summary>
    private static async Task<OffsetChoice> ChoiceAsync(CommandContext context)
    {
        var (erases, layer) = (false, default(int?));
        var first = new AmountPrompt(Wording.Get("Offset.SpecifyDistance"), way => way.Length) { Least = LeastDistance, Most = LargestDistance, Options = Keyword.List("Through", "Erase", "Layer"), Default = context.Remembered(Last, "Through") };
        for (var prompt = first; ;)
        {
            switch (await context.AskAsync(prompt).ConfigureAwait(false))
            {
                case Answer<Amount>.Value { Of: Amount.Number { Of: var distance } }:
                    context.Remember(Last, distance.ToString("R", CultureInfo.InvariantCulture));
                    return new OffsetChoice(distance, erases, layer);
                case Answer<Amount>.Value { Of: Amount.Beginning { At: var place } }:
                    prompt = first with { Instruction = Wording.Get("Common.SpecifySecondPoint"), Options = [], Default = null, From = place };
                    break;
                case Answer<Amount>.Chosen { Option: "Erase" }:
                    erases = await context.ConfirmAsync(Wording.Get("Offset.EraseSource")).ConfigureAwait(false);
                    break;
                case Answer<Amount>.Chosen { Option: "Layer" }:
                    layer = await LayerAsync(context).ConfigureAwait(false);
                    break;
                default:
                    context.Remember(Last, "Through");
                    return new OffsetChoice(null, erases, layer);
            }
        }
    }

    /// <exception cref="CommandException">There is no layer of this name.</exception>
    private static async Task<int?> LayerAsync(CommandContext context)
    {
        var answer = await context.AskAsync(new TextPrompt(Wording.Get("Offset.EnterLayer")) { Options = Keyword.List("Source"), Default = "Source" }).ConfigureAwait(false);
        if (answer is not Answer<string>.Value { Of: var name }) return null;
        for (var i = 0; i < context.Drawing.Layers.Count; i++)
        {
            if (context.Drawing.Layers[i].Name.Equals(name, StringComparison.OrdinalIgnoreCase)) return i;
        }

        throw new CommandException(CommandFailure.Usage, Wording.Get("Offset.NoLayer", name));
    }

    private static PointPrompt SidePrompt(CommandContext context, OffsetChoice choice, int entity)
    {
        var (drawing, maxError) = (context.Drawing, context.Document.Current.Settings.MaxErrorMm);
        return new PointPrompt(Wording.Get(choice.Distance is null ? "Offset.SpecifyThroughPoint" : "Offset.SpecifySide"))
        {
            Ghost = place => [.. EntityOffset.Create(drawing, entity, place, choice.Distance, maxError).SelectMany(loop => loop.Segments)],
        };
    }

    /// <summary>A place; null when the operator is done. Undo takes back what this command made, one by one.</summary>
    private static async Task<Point2D?> AnswerAsync(CommandContext context, PointPrompt prompt, int[] made)
    {
        while (true)
        {
            switch (await context.AskAsync(prompt with { Options = Keyword.List("Exit", "Undo"), Default = "Exit" }).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Of: var place }:
                    return place;
                case Answer<Point2D>.Chosen { Option: "Undo" } when made[0] > 0:
                    made[0]--;
                    context.Document.Undo();
                    break;
                case Answer<Point2D>.Chosen { Option: "Undo" }:
                    context.Say(Wording.Get("Offset.NothingToUndo"));
                    break;
                default:
                    return null;
            }
        }
    }

    private static bool Take(CommandContext context, OffsetChoice choice, int entity, Point2D side)
    {
        var drawing = context.Drawing;
        var loops = EntityOffset.Create(drawing, entity, side, choice.Distance, context.Document.Current.Settings.MaxErrorMm);
        if (loops.Count == 0)
        {
            context.Say(Wording.Get("Offset.NothingLeft"), MessageKind.Warning);
            return false;
        }

        var rebuilt = new DrawingRebuild(drawing);
        for (var index = 0; index < drawing.Entities.Count; index++)
        {
            if (!choice.ErasesSource || index != entity) rebuilt.Keep(index);
        }

        var first = rebuilt.Count;
        EntityOffset.Add(rebuilt, drawing, entity, loops, choice.Layer);
        DrawingChange.Take(context, rebuilt, [.. Enumerable.Range(first, loops.Count)]);
        return true;
    }

    /// <param name="Distance">Drawing units; null: through a point.</param>
    /// <param name="ErasesSource">The source goes.</param>
    /// <param name="Layer">Index of the layer of what is made; null for that of the source.</param>
    private sealed record OffsetChoice(double? Distance, bool ErasesSource, int? Layer);
}
