using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Commands.Files;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Texts;

/// <summary>TEXT: Writes lines of text until an empty Enter, each an object of its own below the one before. All lines are one undo step.</summary>
internal sealed class TextCommand : ICommand
{
    /// <summary>Distance of two lines as a multiple of the height, as in AutoCAD.</summary>
    private const double LineDistance = 5.0 / 3.0;

    private const string Turn = "TEXTANGLE";
    private const double MaxAngle = 1e6;
    private const double MinHeight = 1e-6;

    public CommandInfo Info { get; } = new("TEXT", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        NewDrawing.EnsureOpen(context);
        var draft = await PlaceAsync(context, TextDraft.Current(context)).ConfigureAwait(false);
        if (!draft.Justification.IsAligned && draft.Style.FixedHeight <= 0.0) draft = draft with { Height = await HeightAsync(context, draft).ConfigureAwait(false) };
        if (!draft.Justification.IsBetween) draft = draft with { Rotation = await RotationAsync(context, draft.At).ConfigureAwait(false) };
        await WriteAsync(context, draft).ConfigureAwait(false);
    }

    /// <summary>The height of the letters, typed or shown by a second point.</summary>
    public static async Task<double> HeightAsync(CommandContext context, TextDraft draft)
    {
        var prompt = new AmountPrompt(Wording.Get("Text.SpecifyHeight"), way => way.Length) { Default = NumberPrompt.Format(TextDraft.LastHeight(context)), Min = MinHeight, Max = Drawing.LargestCoordinate, From = draft.At };
        var height = ((Amount.Number)await context.ValueAsync(prompt).ConfigureAwait(false)).Value;
        TextDraft.RememberHeight(context, height);
        return height;
    }

    /// <summary>The direction of the line, typed in degrees or shown by a second point.</summary>
    public static async Task<Angle> RotationAsync(CommandContext context, Point2D from)
    {
        var prompt = new AmountPrompt(Wording.Get("Text.SpecifyRotation"), way => way.Direction.Positive().Degrees) { Default = context.LastValue(Turn, "0"), Min = -MaxAngle, Max = MaxAngle, From = from };
        var degrees = ((Amount.Number)await context.ValueAsync(prompt).ConfigureAwait(false)).Value;
        context.Remember(Turn, NumberPrompt.Format(degrees));
        return Angle.FromDegrees(degrees);
    }

    private static async Task<TextDraft> PlaceAsync(CommandContext context, TextDraft draft)
    {
        while (true)
        {
            context.WriteMessage(Wording.Get("Text.Current", draft.Style.Name, context.Precision.FormatLength(draft.Height), draft.Justification.Shown));
            switch (await context.AskAsync(StartPrompt(draft)).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Result: var at }:
                    return await EndedAsync(context, draft with { At = at }).ConfigureAwait(false);
                case Answer<Point2D>.SelectedOption { Option: "Justify" }:
                    var names = TextJustification.All.Select(one => one.Name).ToArray();
                    var name = await context.ChoiceAsync(Wording.Get("Common.EnterOption"), Keyword.List(names), draft.Justification.Name).ConfigureAwait(false);
                    draft = draft with { Justification = TextJustification.All.First(one => one.Name == name) };
                    break;
                case Answer<Point2D>.SelectedOption:
                    var style = await TextStylePrompts.NameAsync(context, Wording.Get("Text.EnterStyle"), allowsNew: false).ConfigureAwait(false);
                    if (style != context.Document.Current.CurrentStyle) context.Commit(context.Document.Current with { CurrentStyle = style });
                    draft = TextDraft.Current(context) with { Justification = draft.Justification };
                    break;
                default:
                    if (Below(context) is { } below) return below;
                    context.WriteMessage(Wording.Get("Drafting.NothingToContinue"));
                    break;
            }
        }
    }

    private static PointPrompt StartPrompt(TextDraft draft) => new(Wording.Get(draft.Justification.IsBetween ? "Text.SpecifyFirstEnd" : draft.Justification.IsLeft ? "Text.SpecifyStart" : "Text.SpecifyPoint", draft.Justification.Shown))
    {
        Options = Keyword.List("Justify", "Style"), EnterEnds = true,
    };

    private static async Task<TextDraft> EndedAsync(CommandContext context, TextDraft draft)
    {
        if (!draft.Justification.IsBetween) return draft;
        var prompt = new PointPrompt(Wording.Get("Text.SpecifySecondEnd")) { From = draft.At, Validate = to => to == draft.At ? Wording.Get("Text.EndsCoincide") : null };
        return draft with { To = await context.ValueAsync(prompt).ConfigureAwait(false) };
    }

    /// <summary>The place below the last TEXT, in its form; null if the drawing has none.</summary>
    private static TextDraft? Below(CommandContext context)
    {
        if (context.Drawing.Texts.LastOrDefault(text => text.Type == "TEXT" && text.End is null) is not { } last) return null;
        var draft = TextDraft.Current(context) with { Justification = TextJustification.Of(last), At = new Point2D(last.Position.X, last.Position.Y), Height = last.Height, Rotation = last.Rotation };
        return draft with { Style = CurrentTextStyle.Find(context.Drawing, last.Style) ?? draft.Style, At = draft.At + Down(draft) };
    }

    private static Vector2D Down(TextDraft draft) => Vector2D.FromPolar(LineDistance * draft.Height, (draft.To is { } to ? (to - draft.At).Direction : draft.Rotation) - Angle.FromDegrees(90.0));

    private static async Task WriteAsync(CommandContext context, TextDraft draft)
    {
        var steps = new UndoGroup(context);
        while (true)
        {
            var (drawing, line) = (context.Drawing, draft);
            var prompt = new TextPrompt(Wording.Get("Text.EnterText")) { EnterEnds = true, TypedGhost = typed => typed.Length == 0 ? [] : TextDraft.Preview(drawing, line.Line(typed, 0)) };
            if (await context.AskAsync(prompt).ConfigureAwait(false) is not Answer<string>.Value { Result: var typed }) return;
            steps.Commit(draft.AddTo(context.Document.Current, layer => line.Line(typed, layer)));
            draft = draft with { At = draft.At + Down(draft), To = draft.To is { } to ? to + Down(draft) : null };
        }
    }
}
