using System.Text.RegularExpressions;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Packages;

/// <summary>THIRD-PARTY-NOTICES.txt: a table of packages, and the text of each licence under a heading.</summary>
internal sealed partial class NoticeFile
{
    public const string Name = "THIRD-PARTY-NOTICES.txt";

    /// <summary>The version of packages that Avalonia's standard back ends require; only a build on Windows or macOS restores them.</summary>
    public const string RequiredByAvalonia = "*";

    private readonly string _text = File.ReadAllText(Path.Combine(RepositoryFolder.Root, Name));

    public IReadOnlyList<NoticeRow> Rows => [.. Row().Matches(_text).Select(row => new NoticeRow(row.Groups[1].Value, row.Groups[2].Value, row.Groups[3].Value, row.Groups[4].Value))];

    public IReadOnlyList<string> Licences => [.. Licence().Matches(_text).Select(heading => heading.Groups[1].Value)];

    public bool Contains(string text) => _text.Contains(text, StringComparison.Ordinal);

    [GeneratedRegex(@"^([\w.-]+) +\| (\*|[\d.]+) +\| ([\w.-]+) +\| (.+)$", RegexOptions.Multiline)]
    private static partial Regex Row();

    [GeneratedRegex(@"^LICENCE: (\S+)$", RegexOptions.Multiline)]
    private static partial Regex Licence();
}

internal sealed record NoticeRow(string Id, string Version, string Licence, string Copyright);
