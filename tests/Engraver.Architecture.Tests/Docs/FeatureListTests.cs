using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Docs;

/// <summary>Every test, file and verb that docs/features.md and docs/benchmarks.md name exists.</summary>
public partial class FeatureListTests
{
    private static readonly Lazy<ILookup<string, SourceFile>> s_tests = new(() => SourceFile.Under("tests", ".cs").ToLookup(file => Path.GetFileNameWithoutExtension(file.FileName)));

    /// <summary>The verbs of the command line, from which docs/verbs.md is generated.</summary>
    private static readonly Lazy<HashSet<string>> s_verbs = new(() => [.. VerbHeading().Matches(File.ReadAllText(Path.Combine(RepositoryFolder.Root, "docs", "verbs.md"))).Select(verb => verb.Groups["verb"].Value)]);

    public static TheoryData<string> Pages => ["docs/features.md", "docs/benchmarks.md"];

    [Theory]
    [MemberData(nameof(Pages))]
    public void Every_test_and_file_named_exists(string page)
    {
        var wrong = new List<string>();
        var count = 0;
        var lines = File.ReadAllLines(Path.Combine(RepositoryFolder.Root, page));
        for (var i = 0; i < lines.Length; i++)
        {
            foreach (Match name in Quoted().Matches(lines[i]))
            {
                count++;
                if (Missing(name.Groups["what"].Value, name.Groups["project"].Value) is { } why) wrong.Add($"{page}({i + 1}): {why}");
            }
        }

        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
        Assert.True(count > 0, "Nothing was looked up.");
    }

    [Theory]
    [InlineData("FeatureListTests", "", true)]
    [InlineData("FeatureListTests.Every_test_and_file_named_exists", "", true)]
    [InlineData("FeatureListTests.Every_test_and_...", "", true)]
    [InlineData("FeatureListTests.No_such_test", "", false)]
    [InlineData("NoSuchTests", "", false)]
    [InlineData("FeatureListTests", "Engraver.Core.Tests", false)]
    [InlineData("docs/no-such-page.md", "", false)]
    [InlineData("./engraver nosuchverb FILE", "", false)]
    [InlineData("./engraver none FILE", "", false)]
    [InlineData("./engraver info samples/paper-001.dxf --json", "", true)]
    [InlineData("./engraver info samples/no-such.dxf", "", false)]
    public void A_name_that_does_not_exist_is_noticed(string what, string project, bool exists) => Assert.Equal(exists, Missing(what, project) is null);

    /// <summary>The fault of a name in backticks; null when it exists, or does not name a test, file or verb.</summary>
    private static string? Missing(string what, string project) =>
        TestName().Match(what) is { Success: true } test ? MissingTest(test.Groups["class"].Value, test.Groups["method"].Value.TrimEnd('.'), project)
        : what.StartsWith("./engraver ", StringComparison.Ordinal) ? MissingVerb(what)
        : FilePath().IsMatch(what) ? MissingFile(what)
        : null;

    private static string? MissingTest(string name, string method, string project)
    {
        var files = s_tests.Value[name].Where(file => project.Length == 0 || file.Name.StartsWith($"tests/{project}/", StringComparison.Ordinal)).ToList();
        if (files.Count == 0) return $"there is no {name} {(project.Length > 0 ? "in " + project : "")}";
        return method.Length == 0 || files.Any(file => Regex.IsMatch(file.Text, $@"\s{Regex.Escape(method)}\w*\(")) ? null : $"{name} has no test {method}";
    }

    private static string? MissingVerb(string command)
    {
        var words = command.Split(' ');
        return s_verbs.Value.Contains(words[1]) ? words.Where(word => word.StartsWith("samples/", StringComparison.Ordinal)).Select(MissingFile).FirstOrDefault(why => why is not null) : $"there is no verb {words[1]}";
    }

    private static string? MissingFile(string path)
    {
        string[] places = [path, "tests/" + path];
        return places.Select(place => Path.Combine(RepositoryFolder.Root, place)).Any(place => File.Exists(place) || Directory.Exists(place)) ? null : $"there is no {path}";
    }

    [GeneratedRegex(@"`(?<what>[^`]+)`( \((?<project>Engraver\.\w+\.Tests)(/\w+)?\))?")]
    private static partial Regex Quoted();

    [GeneratedRegex(@"^(?<class>\w+Tests)(\.(?<method>[A-Z]\w+(\.\.\.)?))?$")]
    private static partial Regex TestName();

    [GeneratedRegex(@"^## engraver (?<verb>\S+)", RegexOptions.Multiline)]
    private static partial Regex VerbHeading();

    [GeneratedRegex(@"^(docs|samples|src|tests|Engraver\.\w+(\.Tests)?)/[\w./-]*$")]
    private static partial Regex FilePath();
}
