using System.Text.RegularExpressions;

namespace Engraver.Architecture.Tests.Citations;

/// <summary>A reference in a source or a comment to a page and a section in it.</summary>
/// <param name="Page">File name of the page, found in docs/reference or docs.</param>
/// <param name="Mark">Mark of the section (B.3, EX12, 5); empty for the whole page.</param>
/// <param name="Details">Words and numbers of that section to which the citation refers ("A.8 codes 80 to 82", "E, Array").</param>
public sealed record Citation(string Page, string Mark, IReadOnlyList<string> Details);

/// <summary>Finds the forms of citation of this repository.</summary>
public static partial class CitationReader
{
    public const string Controller = "galil-dmc.md";
    public const string Operator = "hmi-conventions.md";
    public const string Contract = "cli-contract.md";
    public const string Papers = "papers.md";

    /// <summary>Every citation with its place in the text: pages by name, sections of the controller reference in comments, the runner's contract,
    /// papers by number.</summary>
    /// <param name="text">The whole file; file names are found in strings too.</param>
    /// <param name="prose">The same with code blanked: bare marks and words are searched only here.</param>
    public static IEnumerable<(int Position, Citation Citation)> Read(string text, string prose) =>
        [.. Pages(text), .. BareMarks(prose), .. ContractVerbs(prose), .. PaperNumbers(prose)];

    private static IEnumerable<(int, Citation)> Pages(string text)
    {
        foreach (Match page in PageName().Matches(text))
        {
            var name = page.Groups["page"].Value;
            var marks = Marks(Tail(text, page.Index + page.Length)).ToList();
            if (marks.Count == 0) yield return (page.Index, new Citation(name, "", []));
            foreach (var (mark, details) in marks) yield return (page.Index, new Citation(name, mark, details));
        }
    }

    /// <summary>The text after the name of the page, up to the end of the bracket or sentence; consecutive comment lines are one text.</summary>
    private static string Tail(string text, int from)
    {
        var tail = NextCommentLine().Replace(text.Substring(from, Math.Min(240, text.Length - from)), " ");
        return tail[..(EndOfCitation().Match(tail) is { Success: true } end ? end.Index : tail.Length)];
    }

    private static IEnumerable<(string Mark, IReadOnlyList<string> Details)> Marks(string tail)
    {
        var places = Mark().Matches(tail);
        for (var i = 0; i < places.Count; i++)
        {
            var end = i + 1 < places.Count ? places[i + 1].Index : tail.Length;
            var after = tail[(places[i].Index + places[i].Length)..end];
            yield return (places[i].Groups["mark"].Value.Replace(' ', '.'), [.. Detail().Matches(after).Select(word => word.Value)]);
        }
    }

    private static IEnumerable<(int, Citation)> BareMarks(string prose) =>
        BareMark().Matches(prose).Select(found => (found.Index, new Citation(Controller, found.Groups["mark"].Value, [])));

    private static IEnumerable<(int, Citation)> ContractVerbs(string prose) =>
        ContractWord().Matches(prose).Select(found => (found.Index, new Citation(Contract, "", found.Groups["verb"].Success ? [found.Groups["verb"].Value] : [])));

    private static IEnumerable<(int, Citation)> PaperNumbers(string prose) =>
        PaperNumber().Matches(prose).Select(found => (found.Index, new Citation(Papers, "", [$"Paper {found.Groups["number"].Value}"])));

    [GeneratedRegex(@"(?<page>(galil-dmc|paper-001-readings|hmi-conventions|sace-xps-agie|dotnet-stack|avalonia-platform|cli-contract|architecture|papers|user-asks)\.md)", RegexOptions.ExplicitCapture)]
    private static partial Regex PageName();

    [GeneratedRegex(@"\s*\n\s*(///?|\*)?\s*")]
    private static partial Regex NextCommentLine();

    [GeneratedRegex(@"[):`]|\.(?=\s|$|<)|</|\b(galil-dmc|hmi-conventions)\.md")]
    private static partial Regex EndOfCitation();

    [GeneratedRegex(@"(?<=^,? ?(sections? )?|[,;] |\b(to|and|section|sections) )(?<mark>EX\d+|0\.\d|[A-L](\.\d+)+|[IJ] \d+|[A-L](?=$|[,;]| [A-Z@(])|\d(?=$|[,; ]))", RegexOptions.ExplicitCapture)]
    private static partial Regex Mark();

    [GeneratedRegex(@"(?<=\b(method|points?|codes?) )\d+|@?\b[A-Z][A-Za-z]+\b", RegexOptions.ExplicitCapture)]
    private static partial Regex Detail();

    [GeneratedRegex(@"(?<![\w.`#-])(?<mark>EX\d{1,2}|[A-L]\.\d{1,2})(?![\w-])|\bsections? (?<mark>[A-L](\.\d+)?)\b", RegexOptions.ExplicitCapture)]
    private static partial Regex BareMark();

    [GeneratedRegex(@"\b([Rr]unner's |[Cc][Ll][Ii] )?contract\b( of ""(?<verb>engraver \w+)"")?", RegexOptions.ExplicitCapture)]
    private static partial Regex ContractWord();

    [GeneratedRegex(@"\b[Pp]aper (?<number>\d{3})\b", RegexOptions.ExplicitCapture)]
    private static partial Regex PaperNumber();
}
