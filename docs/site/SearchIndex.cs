using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.RegularExpressions;
using Markdig.Renderers.Html;
using Markdig.Syntax;

namespace Engraver.Site;

/// <summary>The words of all pages by section, as a script: a page that is opened as a file may load scripts, but no data.</summary>
internal static partial class SearchIndex
{
    private static readonly JsonSerializerOptions s_format = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <returns><c>searchIndex = [[title, address, [[anchor, heading, text], ...]], ...];</c></returns>
    public static string Render(IEnumerable<SitePage> pages) =>
        "var searchIndex = [\n" + string.Join(",\n", pages.Select(page => JsonSerializer.Serialize(new object[] { page.Title, page.Address, Sections(page).Select(section => new[] { section.Id, section.Heading, section.Text }) }, s_format))) + "\n];\n";

    private static List<(string Id, string Heading, string Text)> Sections(SitePage page)
    {
        var sections = new List<(string Id, string Heading, string Text)>();
        var (id, heading, text) = ("", page.Title, new StringBuilder());
        void End()
        {
            if (text.Length > 0 || id.Length > 0) sections.Add((id, heading, Blanks().Replace(text.ToString(), " ").Trim()));
            text.Clear();
        }

        foreach (var block in page.Document.Descendants<LeafBlock>())
        {
            if (block is HeadingBlock { Level: > 1 and < 4 } next)
            {
                End();
                (id, heading) = (next.GetAttributes().Id ?? "", SitePage.TextOf(next.Inline));
            }
            else if (block is CodeBlock)
            {
                text.Append(block.Lines.ToString()).Append(' ');
            }
            else if (block.Inline is not null && block is not HeadingBlock { Level: 1 })
            {
                text.Append(SitePage.TextOf(block.Inline)).Append(' ');
            }
        }

        End();
        return sections;
    }

    [GeneratedRegex(@"\s+")]
    private static partial Regex Blanks();
}
