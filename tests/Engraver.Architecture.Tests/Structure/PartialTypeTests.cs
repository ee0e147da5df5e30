using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>A type is in one file, and partial only where a generator adds the rest: code-behind of a view, regular expressions, JSON contexts, native
/// functions. A type that is too long is two types.</summary>
public partial class PartialTypeTests
{
    private static readonly Lazy<IReadOnlyList<SourceFile>> s_files = new(() => [.. new[] { "src", "tests", "tools", "benchmarks" }.SelectMany(folder => SourceFile.Under(folder, ".cs"))]);

    [Fact]
    public void No_type_is_in_two_files()
    {
        var divided = Divided(s_files.Value).ToList();
        Assert.True(s_files.Value.Count > 1000 && divided.Count == 0, $"Make a class of its own of each task:\n{string.Join('\n', divided)}");
    }

    [Fact]
    public void A_type_is_partial_only_where_a_generator_adds_to_it()
    {
        var needless = s_files.Value.SelectMany(Needless).ToList();
        Assert.True(needless.Count == 0, $"Not partial:\n{string.Join('\n', needless)}");
    }

    [Fact]
    public void A_type_in_two_files_is_noticed()
    {
        var one = new SourceFile("src/P/One.cs", "namespace P;\npublic sealed partial class One : IOne\n{\n}\n");
        var more = new SourceFile("src/P/One.More.cs", "namespace P;\npublic sealed partial class One\n{\n}\n");
        var other = new SourceFile("src/P/Other/One.cs", "namespace P.Other;\npublic partial record One;\n");
        Assert.Equal(["P.One: src/P/One.cs, src/P/One.More.cs"], Divided([one, more, other]));
        Assert.Equal(["src/P/One.cs: One"], Needless(one));
    }

    private static IEnumerable<string> Divided(IReadOnlyList<SourceFile> files) => files
        .SelectMany(file => Partials(file).Select(name => (Name: $"{Namespace().Match(Code(file)).Groups["name"].Value}.{name}", File: file.Name)))
        .Distinct()
        .GroupBy(one => one.Name, one => one.File)
        .Where(type => type.Count() > 1)
        .Select(type => $"{type.Key}: {string.Join(", ", type)}");

    private static IEnumerable<string> Needless(SourceFile file) =>
        file.Name.EndsWith(".axaml.cs", StringComparison.Ordinal) || Generated().IsMatch(Code(file)) ? [] : Partials(file).Select(name => $"{file.Name}: {name}");

    private static IEnumerable<string> Partials(SourceFile file) => Partial().Matches(Code(file)).Select(found => found.Groups["name"].Value);

    private static string Code(SourceFile file) => CSharpText.Parse(file.Text).Code;

    [GeneratedRegex(@"\bpartial\s+(class|struct|interface|record(\s+(class|struct))?)\s+(?<name>\w+)")]
    private static partial Regex Partial();

    [GeneratedRegex(@"^namespace\s+(?<name>[\w.]+)", RegexOptions.Multiline)]
    private static partial Regex Namespace();

    /// <summary>A member that a generator completes, or a JSON context.</summary>
    [GeneratedRegex(@"\bpartial\s+(?!class\b|struct\b|interface\b|record\b)\w|:\s*JsonSerializerContext\b")]
    private static partial Regex Generated();
}
