using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Text;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Commands.Texts;

/// <summary>DDEDIT: Changes the strings of texts and of attribute values, one after the other, until Enter. The codes of an MTEXT are edited as they are in the
/// file.</summary>
internal sealed class TextEditCommand : ICommand
{
    public CommandInfo Info { get; } = new("DDEDIT", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var steps = new UndoGroup(context);
        if (context.Document.Current.Selection is [var only] && ShownDrawing.TextOf(context.Drawing, only) is { } selected)
        {
            await EditAsync(context, steps, selected).ConfigureAwait(false);
            return;
        }

        while (true)
        {
            var prompt = new PointPrompt(Wording.Get("DdEdit.SelectText")) { Options = Keyword.List("Undo"), EnterEnds = true, Purpose = PointPurpose.Object };
            switch (await context.AskAsync(prompt).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Result: var at }:
                    if (TextAt(context, at) is { } text) await EditAsync(context, steps, text).ConfigureAwait(false);
                    else context.WriteMessage(Wording.Get("DdEdit.NoText"));
                    break;
                case Answer<Point2D>.SelectedOption:
                    if (!steps.Undo()) context.WriteMessage(Wording.Get("Copy.NothingToUndo"));
                    break;
                default:
                    return;
            }
        }
    }

    /// <summary>A text with another string, as typed.</summary>
    public static PlacedText WithTyped(PlacedText text, string typed)
    {
        ArgumentNullException.ThrowIfNull(text);
        return TextSummary.Derived(text with { Written = text.Written with { Raw = TypedText.ToLine(typed) } });
    }

    private static int? TextAt(CommandContext context, Point2D at)
    {
        var (drawing, shown, reach) = (context.Drawing, ShownDrawing.Of(context.Drawing), ObjectSelection.PickRadius(context));
        if (DrawingPick.Nearest(shown, at, reach) is { } near && ShownDrawing.TextOf(drawing, near) is { } hit) return hit;
        var boxes = Enumerable.Range(0, drawing.Texts.Count).Where(text => DrawingPick.BoundsOf(shown, [drawing.Entities.Count + text]) is { IsEmpty: false } box && drawing.Texts[text].IsVisibleIn(drawing) && box.Contains(at));
        return boxes.Select(text => (int?)text).FirstOrDefault(); // between the letters
    }

    private static async Task EditAsync(CommandContext context, UndoGroup steps, int text)
    {
        var (drawing, before) = (context.Drawing, context.Drawing.Texts[text]);
        if (drawing.Layers[before.Layer].Locked)
        {
            context.WriteMessage(Wording.Get("ObjectSelection.Locked", 1));
            return;
        }

        context.HighlightPicked([drawing.Entities.Count + text]);
        var prompt = new TextPrompt(Wording.Get("DdEdit.EnterText")) { Default = TypedText.FromRaw(before.Written.Raw), EditsDefault = true, TypedGhost = typed => typed.Length == 0 ? [] : TextDraft.Preview(drawing, WithTyped(before, typed)) };
        var typed = await context.ValueAsync(prompt).ConfigureAwait(false);
        context.HighlightPicked(null);
        if (WithTyped(before, typed) is var after && after.Written.Raw == before.Written.Raw) return;
        if (after.Content.Trim().Length == 0) context.WriteMessage(Wording.Get("DdEdit.Empty"), MessageKind.Warning);
        else steps.Commit(context.Document.Current with { Drawing = TextChange.Replaced(drawing, text, after) });
    }
}
