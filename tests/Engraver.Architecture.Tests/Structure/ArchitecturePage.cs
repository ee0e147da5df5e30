using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>A row of the table "Projects" in docs/architecture.md: which projects and packages a project may name in its project file.</summary>
public sealed record ProjectRule(string Project, IReadOnlyList<string> MayReference, IReadOnlyList<string> Packages)
{
    /// <summary>The rows for src/, in the order of the page.</summary>
    public static IReadOnlyList<ProjectRule> All { get; } = [.. Rows()];

    private static IEnumerable<ProjectRule> Rows() =>
        from row in SourceFile.Read(Path.Combine(RepositoryFolder.Root, "docs", "architecture.md")).Text.Split('\n')
        where row.StartsWith("| `src/Engraver.", StringComparison.Ordinal)
        let cells = row.Split('|', StringSplitOptions.TrimEntries)
        select new ProjectRule(Quoted(cells[1]).Single()["src/".Length..], [.. Quoted(cells[3])], [.. Quoted(cells[4])]);

    private static IEnumerable<string> Quoted(string cell) => Regex.Matches(cell, "`([^`]+)`").Select(found => found.Groups[1].Value);
}
