using System.Globalization;
using Engraver.Core.Languages;

namespace Engraver.Workbench.Reports.Pages;

/// <summary>Writes a page that is HTML and well-formed XML at once. Every text goes through <see cref="MarkupText"/>; only pictures are written as they are.</summary>
internal sealed class PageWriter(TextWriter output)
{
    /// <summary>The beginning up to the first heading. No other page or program may be reached from it.</summary>
    public void Begin(string title)
    {
        Line("<!DOCTYPE html>");
        Line($"<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"{MarkupText.Escaped(CultureInfo.CurrentUICulture.TwoLetterISOLanguageName is "iv" ? "en" : CultureInfo.CurrentUICulture.TwoLetterISOLanguageName)}\">");
        Line("<head>");
        Line("<meta charset=\"utf-8\"/>");
        Line("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\"/>");
        Line("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>");
        Line($"<title>{MarkupText.Escaped(title)}</title>");
        Line($"<style>\n{PageStyle.Css.ReplaceLineEndings("\n")}\n</style>");
        Line("</head>");
        Line("<body>");
        Line($"<h1>{MarkupText.Escaped(title)}</h1>");
    }

    public void End()
    {
        Line("</body>");
        Line("</html>");
    }

    /// <param name="key">Names the part for programs that read the page.</param>
    public void Section(string key, string heading, Action write)
    {
        Line($"<section id=\"{MarkupText.Escaped(key)}\">");
        Line($"<h2>{MarkupText.Escaped(heading)}</h2>");
        write();
        Line("</section>");
    }

    public void Paragraph(string text, string style = "") => Line($"<p{Class(style)}>{MarkupText.Escaped(text)}</p>");

    /// <summary>A frame for what is written inside as it is.</summary>
    public void Figure(string style, Action<TextWriter> picture)
    {
        Line($"<figure{Class(style)}>");
        picture(output);
        Line("</figure>");
    }

    public void Inside(string style, Action write)
    {
        Line($"<div{Class(style)}>");
        write();
        Line("</div>");
    }

    /// <summary>A table of names and values. A figure stands exact in <c>data-value</c>, under its name in the JSON of the console.</summary>
    public void Pairs(IEnumerable<PagePair> pairs)
    {
        Line("<table class=\"pair\">");
        foreach (var (name, text) in pairs.Select(pair => (pair, pair.Text)))
        {
            var data = name.Key is { } key ? $" data-name=\"{MarkupText.Escaped(key)}\"" + (name.Value is { } value ? $" data-value=\"{value.ToString("R", CultureInfo.InvariantCulture)}\"" : "") : "";
            Line($"<tr><th scope=\"row\">{MarkupText.Escaped(name.Name)}</th><td{Class(name.Style)}{data}>{MarkupText.Escaped(text)}</td></tr>");
        }

        Line("</table>");
    }

    /// <param name="rows">As many cells as headings.</param>
    public void Table(IReadOnlyList<string> headings, IEnumerable<IReadOnlyList<string>> rows)
    {
        Line("<table>");
        Line($"<thead><tr>{string.Concat(headings.Select(heading => $"<th scope=\"col\">{MarkupText.Escaped(heading)}</th>"))}</tr></thead>");
        Line("<tbody>");
        foreach (var row in rows) Line($"<tr>{string.Concat(row.Select((cell, column) => $"<td{Class(column == 0 ? "mark" : "")}>{MarkupText.Escaped(cell)}</td>"))}</tr>");
        Line("</tbody>");
        Line("</table>");
    }

    private static string Class(string style) => style.Length == 0 ? "" : $" class=\"{style}\"";

    private void Line(string text)
    {
        output.Write(text);
        output.Write('\n');
    }
}

/// <summary>A name with its value.</summary>
/// <param name="Key">Name in the JSON of the console; null for what no program reads.</param>
/// <param name="Value">The exact figure; null for words.</param>
internal sealed record PagePair(string Name, string Text, string? Key = null, double? Value = null, string Style = "")
{
    /// <summary>A figure with its unit.</summary>
    public static PagePair Of(string name, string key, double? value, string form) =>
        new(name, value is { } known ? known.ToString(form, CultureInfo.InvariantCulture) : "–", key, value, "number");
}
