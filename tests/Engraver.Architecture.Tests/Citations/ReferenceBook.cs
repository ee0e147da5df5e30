using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Citations;

/// <summary>A page of docs/ by its headings: the mark of a section (A.3, EX12, 5) and the text below it, including inner sections.</summary>
public sealed partial class ReferenceBook
{
    private readonly Dictionary<string, string> _sections = [];

    private ReferenceBook(string text)
    {
        Text = text;
        var headings = Headings(text);
        for (var i = 0; i < headings.Count; i++)
        {
            var end = headings.Skip(i + 1).FirstOrDefault(next => next.Level <= headings[i].Level);
            _sections.TryAdd(headings[i].Mark, end.Mark is null ? text[headings[i].Start..] : text[headings[i].Start..end.Start]);
        }
    }

    public string Text { get; }

    public IReadOnlyCollection<string> Marks => _sections.Keys;

    /// <summary>The page of this name in docs/reference or docs; null if there is none.</summary>
    public static ReferenceBook? Open(string fileName)
    {
        string[] places = [Path.Combine(RepositoryFolder.Root, "docs", "reference", fileName), Path.Combine(RepositoryFolder.Root, "docs", fileName)];
        return places.FirstOrDefault(File.Exists) is { } path ? new ReferenceBook(SourceFile.Read(path).Text) : null;
    }

    /// <summary>The text of a section, or of a numbered row or point of the section around it (I.12 is row 12 of I); null if the page has neither.</summary>
    public string? Section(string mark)
    {
        if (_sections.TryGetValue(mark, out var found)) return found;
        var dot = mark.LastIndexOf('.');
        if (dot < 0 || !_sections.TryGetValue(mark[..dot], out var around)) return null;
        var number = Regex.Escape(mark[(dot + 1)..]);
        return Regex.Match(around, $@"^(\| {number} |{number}\. ).*$", RegexOptions.Multiline) is { Success: true } row ? row.Value : null;
    }

    private static List<(string Mark, int Level, int Start)> Headings(string text)
    {
        var found = new List<(string, int, int)>();
        var fenced = false;
        foreach (Match line in WholeLine().Matches(text))
        {
            if (line.Value.StartsWith("```", StringComparison.Ordinal)) fenced = !fenced;
            else if (!fenced && Heading().Match(line.Value) is { Success: true } heading) found.Add((heading.Groups["mark"].Value.TrimEnd('.'), heading.Groups["level"].Length, line.Index));
        }

        return found;
    }

    [GeneratedRegex("^.*$", RegexOptions.Multiline)]
    private static partial Regex WholeLine();

    [GeneratedRegex(@"^(?<level>#{1,4}) (?<mark>EX\d+|[A-L](\.\d+)*\.?|\d+(\.\d+)*\.?)(?= )")]
    private static partial Regex Heading();
}
