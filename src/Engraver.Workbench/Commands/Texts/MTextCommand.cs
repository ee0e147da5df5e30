using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Commands.Files;

namespace Engraver.Workbench.Commands.Texts;

/// <summary>MTEXT: Writes lines of text that wrap in a frame as one object, until an empty Enter.</summary>
internal sealed class MTextCommand : ICommand
{
    private const double MinSpacing = 0.25;
    private const double MaxSpacing = 4.0;
    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("Height", "Justify", "Linespacing", "Rotation", "Style", "Width");

    public CommandInfo Info { get; } = new("MTEXT", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        NewDrawing.EnsureOpen(context);
        var draft = TextDraft.Current(context) with { Justification = TextJustification.Corners[0] };
        context.WriteMessage(Wording.Get("Text.Current", draft.Style.Name, context.Precision.FormatLength(draft.Height), draft.Justification.Shown));
        var first = await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyFirstCorner"))).ConfigureAwait(false);
        var (formed, form) = await FrameAsync(context, draft with { At = first }, new WrittenParagraphs()).ConfigureAwait(false);
        await WriteAsync(context, formed, form with { Attachment = formed.Justification.Attachment }).ConfigureAwait(false);
    }

    /// <summary>The opposite corner, or a width, which may be 0: the text does not wrap.</summary>
    private static async Task<(TextDraft Draft, WrittenParagraphs Form)> FrameAsync(CommandContext context, TextDraft draft, WrittenParagraphs form)
    {
        while (true)
        {
            var prompt = new PointPrompt(Wording.Get("MText.SpecifyOppositeCorner")) { Options = s_options, Purpose = PointPurpose.Corner, From = draft.At };
            var answer = await context.AskAsync(prompt).ConfigureAwait(false);
            if (answer is Answer<Point2D>.Value { Result: var corner }) return (draft with { At = Reference(draft, corner) }, form with { ReferenceWidth = Math.Abs(corner.X - draft.At.X) });
            switch (((Answer<Point2D>.SelectedOption)answer).Option)
            {
                case "Height": draft = draft with { Height = await TextCommand.HeightAsync(context, draft).ConfigureAwait(false) }; break;
                case "Rotation": draft = draft with { Rotation = await TextCommand.RotationAsync(context, draft.At).ConfigureAwait(false) }; break;
                case "Justify":
                    var names = TextJustification.Corners.Select(one => one.Name).ToArray();
                    var name = await context.ChoiceAsync(Wording.Get("Common.EnterOption"), Keyword.List(names), draft.Justification.Name).ConfigureAwait(false);
                    draft = draft with { Justification = TextJustification.Corners.First(one => one.Name == name) };
                    break;
                case "Linespacing":
                    form = form with { LineSpacingFactor = await context.ValueAsync(new NumberPrompt(Wording.Get("MText.EnterSpacing")) { Default = NumberPrompt.Format(form.LineSpacingFactor), Min = MinSpacing, Max = MaxSpacing }).ConfigureAwait(false) };
                    break;
                case "Style":
                    var style = await TextStylePrompts.NameAsync(context, Wording.Get("Text.EnterStyle"), allowsNew: false).ConfigureAwait(false);
                    if (style != context.Document.Current.CurrentStyle) context.Commit(context.Document.Current with { CurrentStyle = style });
                    draft = draft with { Style = CurrentTextStyle.Of(context.Document.Current) };
                    break;
                default:
                    var width = await context.ValueAsync(new NumberPrompt(Wording.Get("MText.SpecifyWidth")) { Min = 0.0, Max = Drawing.LargestCoordinate }).ConfigureAwait(false);
                    return (draft, form with { ReferenceWidth = width });
            }
        }
    }

    /// <summary>The point of the frame at which the justification holds it.</summary>
    private static Point2D Reference(TextDraft draft, Point2D corner)
    {
        var box = Bounds2D.FromCorners(draft.At, corner);
        return new Point2D(box.MinX + (0.5 * draft.Justification.Horizontal * box.Width), draft.Justification.Vertical switch { 3 => box.MaxY, 2 => 0.5 * (box.MinY + box.MaxY), _ => box.MinY });
    }

    private static async Task WriteAsync(CommandContext context, TextDraft draft, WrittenParagraphs form)
    {
        var (lines, steps) = (new List<string>(), new UndoGroup(context));
        while (true)
        {
            var (drawing, before) = (context.Drawing, lines.ToArray());
            var prompt = new TextPrompt(Wording.Get("MText.EnterLine")) { EnterEnds = true, TypedGhost = typed => typed.Length == 0 ? [] : TextDraft.Preview(drawing, draft.Paragraphs([.. before, typed], 0, form)) };
            if (await context.AskAsync(prompt).ConfigureAwait(false) is not Answer<string>.Value { Result: var typed }) return;
            if (lines.Count > 0) steps.Undo();
            lines.Add(typed);
            steps.Commit(draft.AddTo(context.Document.Current, layer => draft.Paragraphs(lines, layer, form)));
        }
    }
}
