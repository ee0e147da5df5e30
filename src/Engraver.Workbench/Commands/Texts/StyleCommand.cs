using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Fonts.Finding;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Files;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Commands.Texts;

/// <summary>STYLE: Creates a text style or changes one, and makes it current. All texts of the style change their font.</summary>
internal sealed class StyleCommand : ICommand
{
    private const double MaxSlant = 85.0;
    private const double MinWidth = 0.01;
    private const double MaxWidth = 100.0;

    public CommandInfo Info { get; } = new("STYLE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        NewDrawing.EnsureOpen(context);
        var name = await TextStylePrompts.NameAsync(context, Wording.Get("Style.EnterName"), allowsNew: true).ConfigureAwait(false);
        var old = CurrentTextStyle.Find(context.Drawing, name);
        if (old is null && name != CurrentTextStyle.DefaultName) context.WriteMessage(Wording.Get("Style.New", name));
        var style = old ?? new TextStyle(name) { FontFile = CurrentTextStyle.OwnFont };
        style = await FontAsync(context, style).ConfigureAwait(false);
        style = style with { FixedHeight = await NumberAsync(context, "Style.EnterHeight", style.FixedHeight, 0.0, Drawing.LargestCoordinate).ConfigureAwait(false) };
        style = style with { WidthFactor = await NumberAsync(context, "Style.EnterWidth", style.WidthFactor, MinWidth, MaxWidth).ConfigureAwait(false) };
        style = style with { Oblique = Angle.FromDegrees(await NumberAsync(context, "Style.EnterOblique", style.Oblique.Degrees, -MaxSlant, MaxSlant).ConfigureAwait(false)) };
        var generation = await GenerationAsync(context, "Style.Backwards", style.Generation, TextGeneration.Backwards).ConfigureAwait(false);
        style = style with { Generation = await GenerationAsync(context, "Style.UpsideDown", generation, TextGeneration.UpsideDown).ConfigureAwait(false) };
        Commit(context, style);
        context.WriteMessage(Wording.Get("Style.IsCurrent", style.Name));
    }

    private static async Task<TextStyle> FontAsync(CommandContext context, TextStyle style)
    {
        var typed = (await context.ValueAsync(new TextPrompt(Wording.Get("Style.EnterFont")) { Default = TextStylePrompts.FontOf(style) }).ConfigureAwait(false)).Trim();
        if (typed == TextStylePrompts.FontOf(style)) return style;
        var isFile = FontLibrary.IsFontFile(typed);
        var byFile = style with { FontFile = typed, Family = "", FamilyFlags = 0, BigFontFile = "" };
        var named = isFile || Found(context, byFile).Match == FontMatch.Exact ? byFile : byFile with { FontFile = "", Family = typed };
        if (Found(context, named) is { Match: not FontMatch.Exact } other) context.WriteMessage(Wording.Get("Style.FontNotFound", typed, other.Font.Name), MessageKind.Warning);
        return named;
    }

    private static FoundFont Found(CommandContext context, TextStyle style) => LetterLibrary.FontsOf(context.Drawing).Of(style);

    private static async Task<double> NumberAsync(CommandContext context, string question, double now, double min, double max) =>
        await context.ValueAsync(new NumberPrompt(Wording.Get(question)) { Default = NumberPrompt.Format(now), Min = min, Max = max }).ConfigureAwait(false);

    private static async Task<TextGeneration> GenerationAsync(CommandContext context, string question, TextGeneration now, TextGeneration flag)
    {
        var answer = await context.ChoiceAsync(Wording.Get(question), Keyword.List("Yes", "No"), now.HasFlag(flag) ? "Yes" : "No").ConfigureAwait(false);
        return answer == "Yes" ? now | flag : now & ~flag;
    }

    private static void Commit(CommandContext context, TextStyle style)
    {
        var drawing = context.Drawing;
        var isKnown = CurrentTextStyle.Find(drawing, style.Name) is not null;
        IReadOnlyList<TextStyle> styles = isKnown ? [.. drawing.Styles.Select(one => IsThis(one.Name) ? style : one)] : [.. drawing.Styles, style];
        IReadOnlyList<PlacedText> texts = drawing.Texts.Any(text => IsThis(text.Style)) ? [.. drawing.Texts.Select(text => IsThis(text.Style) ? text with { Font = style.FontFile } : text)] : drawing.Texts;
        context.Commit(context.Document.Current with { Drawing = drawing with { Styles = styles, Texts = texts }, CurrentStyle = style.Name });

        bool IsThis(string name) => name.Equals(style.Name, StringComparison.OrdinalIgnoreCase);
    }
}
