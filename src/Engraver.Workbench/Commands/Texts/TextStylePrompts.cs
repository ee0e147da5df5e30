using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Texts;

/// <summary>Asks for a text style by name; ? lists them.</summary>
internal static class TextStylePrompts
{
    private const string List = "?";

    /// <param name="allowsNew">A name that the drawing does not have is accepted.</param>
    /// <returns>The typed or the current name.</returns>
    public static async Task<string> NameAsync(CommandContext context, string instruction, bool allowsNew)
    {
        var current = CurrentTextStyle.Of(context.Document.Current).Name;
        while (true)
        {
            var name = (await context.ValueAsync(new TextPrompt(instruction) { Default = current }).ConfigureAwait(false)).Trim();
            if (name == List) Write(context);
            else if (allowsNew || CurrentTextStyle.Find(context.Drawing, name) is not null || name == current) return name;
            else context.WriteMessage(Wording.Get("TextStyle.NotFound", name), MessageKind.Warning);
        }
    }

    private static void Write(CommandContext context) => context.WriteResult(output =>
    {
        foreach (var style in context.Drawing.Styles.Count > 0 ? context.Drawing.Styles : [CurrentTextStyle.Of(context.Document.Current)]) output.WriteLine(Describe(context, style));
    });

    /// <summary>A style with its values in words.</summary>
    public static string Describe(CommandContext context, TextStyle style) =>
        Wording.Get("TextStyle.Line", style.Name, FontOf(style), context.Precision.FormatLength(style.FixedHeight), context.Precision.FormatLength(style.WidthFactor), context.Precision.FormatDegrees(style.Oblique));

    /// <summary>The font as it is typed.</summary>
    public static string FontOf(TextStyle style) => style.FontFile.Length > 0 ? style.FontFile : style.Family.Length > 0 ? style.Family : CurrentTextStyle.OwnFont;
}
