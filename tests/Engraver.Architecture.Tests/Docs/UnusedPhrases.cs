using System.Text.RegularExpressions;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Docs;

/// <summary>The table "Phrases we do not use" of CONTRIBUTING.md. A phrase matches whole words in any case.</summary>
public sealed partial class UnusedPhrases
{
    public const string Heading = "## Phrases we do not use";

    private readonly IReadOnlyList<Rule> _rules;

    private UnusedPhrases(IReadOnlyList<Rule> rules) => _rules = rules;

    public int Count => _rules.Count;

    public static UnusedPhrases Read() => Parse(File.ReadAllText(Path.Combine(RepositoryFolder.Root, "CONTRIBUTING.md")));

    /// <param name="page">A page with the heading and, under it, a table of three columns: phrases, replacement, allowed expressions. Several are separated
    /// by commas.</param>
    public static UnusedPhrases Parse(string page)
    {
        var rows = SectionOf(page).Split('\n').Where(line => line.StartsWith('|')).Skip(2).Select(line => line.Trim('|', ' ').Split('|'));
        return new UnusedPhrases([.. rows.Select(cells => new Rule(Expression(cells[0]), cells[1].Trim(), cells.Length > 2 && cells[2].Trim().Length > 0 ? Expression(cells[2]) : null))]);
    }

    /// <summary>The page without the table, which has to name the phrases.</summary>
    public static string WithoutTable(string page) => SectionOf(page) is { Length: > 0 } section ? page.Replace(section, Blank(section), StringComparison.Ordinal) : page;

    /// <summary>Where the text has an unused phrase: its index, the words, and what to write instead.</summary>
    public IEnumerable<(int Index, string Words, string Instead)> Find(string text)
    {
        foreach (var rule in _rules)
        {
            var searched = rule.Allowed is null ? text : rule.Allowed.Replace(text, allowed => Blank(allowed.Value));
            foreach (Match match in rule.Phrases.Matches(searched)) yield return (match.Index, match.Value, rule.Instead);
        }
    }

    private static string SectionOf(string page) =>
        page.IndexOf(Heading, StringComparison.Ordinal) is var start and >= 0 ? page[start..(page.IndexOf("\n## ", start + 1, StringComparison.Ordinal) is var end and >= 0 ? end : page.Length)] : "";

    private static string Blank(string text) => NotLineEnd().Replace(text, " ");

    private static Regex Expression(string cell) =>
        new($@"(?<![\w-])(?:{string.Join('|', cell.Split(',').Select(phrase => Regex.Escape(phrase.Trim()).Replace(@"\ ", @"\s+", StringComparison.Ordinal)))})(?![\w-])", RegexOptions.IgnoreCase);

    [GeneratedRegex(@"[^\n]")]
    private static partial Regex NotLineEnd();

    private sealed record Rule(Regex Phrases, string Instead, Regex? Allowed);
}
