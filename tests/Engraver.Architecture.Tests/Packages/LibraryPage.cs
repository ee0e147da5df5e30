using System.Text.RegularExpressions;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Packages;

/// <summary>The samples of docs/library.md.</summary>
internal static partial class LibraryPage
{
    /// <summary>The project file.</summary>
    public static string Project => Block("xml", "<Project");

    /// <summary>The classes by name, in the order of the page.</summary>
    public static IReadOnlyList<(string Name, string Code)> Classes => [.. Blocks(Text("docs", "library.md"), "csharp").Select(code => (ClassName().Match(code).Groups[1].Value, code))];

    /// <summary>The only C# sample in the README of a package.</summary>
    public static string SampleOf(string package) => Assert.Single(Blocks(Text("src", package, "README.md"), "csharp"));

    private static string Block(string language, string start) => Blocks(Text("docs", "library.md"), language).Single(block => block.StartsWith(start, StringComparison.Ordinal));

    private static IEnumerable<string> Blocks(string page, string language) => Regex.Matches(page, $"^```{language}\n(.*?)^```", RegexOptions.Multiline | RegexOptions.Singleline).Select(block => block.Groups[1].Value);

    private static string Text(params string[] path) => File.ReadAllText(Path.Combine([RepositoryFolder.Root, .. path])).ReplaceLineEndings("\n");

    [GeneratedRegex(@"public class (\w+)")]
    private static partial Regex ClassName();
}
