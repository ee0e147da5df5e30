using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Texts;

namespace Engraver.Workbench.Commands.Properties;

/// <summary>The properties of texts. An MTEXT shows its string with its codes.</summary>
internal static class TextProperties
{
    private const double MaxSlant = 85.0;

    public static IReadOnlyList<ObjectProperty> All { get; } =
    [
        new("COntents", false) { Read = (facts, _) => facts.Text is { } text ? TypedText.FromRaw(text.Written.Raw) : null, OfText = (_, text, typed) => TextEditCommand.WithTyped(text, typed) },
        new("Style", false)
        {
            Read = (facts, _) => facts.Text?.Style,
            OfText = (facts, text, typed) => TextChange.WithStyle(text, CurrentTextStyle.Find(facts.Drawing, typed.Trim()) ?? throw Wrong("TextStyle.NotFound", typed.Trim())),
            Choices = drawing => [.. drawing.Styles.Select(style => style.Name)],
        },
        new("Justify", false)
        {
            Read = (facts, _) => facts.Text is { } text ? TextJustification.Of(text).Shown : null,
            OfText = (facts, text, typed) => TextChange.WithJustification(facts.Drawing, text, JustificationOf(text, typed.Trim())),
            Choices = _ => [.. TextJustification.All.Select(one => one.Shown)],
        },
        ObjectProperty.Length("TextHeight", facts => facts.Text?.Height) with { OfText = (_, text, typed) => TextChange.WithHeight(text, Number(typed, value => value > 0.0)) },
        ObjectProperty.Angle("TextRotation", facts => facts.Text?.Rotation.Positive()) with { OfText = (_, text, typed) => TextChange.WithRotation(text, Angle.FromDegrees(Number(typed, _ => true))) },
        ObjectProperty.Length("WidthFactor", facts => Line(facts)?.WidthFactor) with { OfText = (_, text, typed) => TextChange.WithWidthFactor(text, Number(typed, value => value > 0.0)) },
        ObjectProperty.Angle("OBlique", facts => Line(facts)?.Oblique) with { OfText = (_, text, typed) => TextChange.WithOblique(text, Angle.FromDegrees(Number(typed, value => Math.Abs(value) <= MaxSlant))) },
        ObjectProperty.Length("PositionX", facts => facts.Text?.Position.X),
        ObjectProperty.Length("PositionY", facts => facts.Text?.Position.Y),
    ];

    /// <summary>Not an MTEXT, which has these values in its codes.</summary>
    private static PlacedText? Line(ObjectFacts facts) => facts.Text is { Written.Paragraphs: null } text ? text : null;

    private static TextJustification JustificationOf(PlacedText text, string typed)
    {
        var all = text.Written.Paragraphs is null ? TextJustification.All : TextJustification.Corners;
        var found = Keyword.Find(Keyword.List([.. all.Select(one => one.Name)]), typed) ?? throw Wrong("ChProp.NotAJustification", typed, string.Join(", ", all.Select(one => one.Shown)));
        return all.First(one => one.Name == found.Name);
    }

    private static double Number(string typed, Predicate<double> isAllowed) =>
        NumberPrompt.TryParse(typed.Trim(), out var value) && isAllowed(value) ? value : throw Wrong("ChProp.NotAllowed", typed);

    private static CommandException Wrong(string text, params object[] facts) => new(CommandFailure.Usage, Wording.Get(text, facts));
}
