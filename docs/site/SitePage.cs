using System.Text;
using Markdig;
using Markdig.Extensions.AutoIdentifiers;
using Markdig.Renderers.Html;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace Engraver.Site;

/// <summary>A heading of a page.</summary>
/// <param name="Id">Its anchor, formed as on code hosts.</param>
public readonly record struct PageHeading(int Level, string Id, string Text);

/// <summary>A Markdown file of the repository, parsed.</summary>
/// <param name="Path">Relative to the root, with slashes.</param>
public sealed record SitePage(string Path, MarkdownDocument Document, IReadOnlyList<PageHeading> Headings)
{
    public static MarkdownPipeline Pipeline { get; } = new MarkdownPipelineBuilder().UsePipeTables().UseAutoLinks().UseAutoIdentifiers(AutoIdentifierOptions.GitHub).UsePreciseSourceLocation().Build();

    public string Title => Headings.FirstOrDefault(heading => heading.Level == 1).Text ?? System.IO.Path.GetFileNameWithoutExtension(Path);

    /// <summary>Where it is in the site: the README of a folder is the folder's index.</summary>
    public string Address => Path == "README.md" || Path.EndsWith("/README.md", StringComparison.Ordinal) ? Path[..^"README.md".Length] + "index.html" : System.IO.Path.ChangeExtension(Path, ".html");

    public static SitePage Parse(string path, string text)
    {
        var document = Markdown.Parse(text, Pipeline);
        var headings = document.Descendants<HeadingBlock>().Select(heading => new PageHeading(heading.Level, heading.GetAttributes().Id ?? "", TextOf(heading.Inline))).ToList();
        return new SitePage(path, document, headings);
    }

    public bool HasAnchor(string id) => Headings.Any(heading => heading.Id == id);

    /// <summary>The words without their form.</summary>
    public static string TextOf(ContainerInline? inlines)
    {
        var text = new StringBuilder();
        foreach (var inline in inlines?.Descendants() ?? [])
        {
            if (inline is LiteralInline literal) text.Append(literal.Content.AsSpan());
            else if (inline is CodeInline code) text.Append(code.Content);
            else if (inline is HtmlEntityInline entity) text.Append(entity.Transcoded.AsSpan());
            else if (inline is LineBreakInline) text.Append(' ');
        }

        return text.ToString();
    }
}
