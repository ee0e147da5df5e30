using System.Text.RegularExpressions;
using System.Xml.Linq;
using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>Texts for people are in Texts.resx: each requested text exists, each existing text is requested, and sources contain no other sentences. Files with
/// other sentences are listed in words.txt, which may only become shorter.</summary>
public partial class WordingTests
{
    private const string ListName = "tests/Engraver.Architecture.Tests/Structure/words.txt";

    public static TheoryData<string> Projects => ["Core", "Galil", "Links", "Workbench", "Cli", "App", "tools"];

    [Theory]
    [MemberData(nameof(Projects))]
    public void Every_text_that_is_asked_for_is_there_with_as_many_facts_as_are_given(string project)
    {
        var texts = Texts(project);
        var wrong = from file in Sources(project)
                    from call in Calls(file)
                    let places = texts.TryGetValue(call.Name, out var text) ? Places(text) : -1
                    where places != call.Facts
                    select $"{file.Name}: {call.Name} has {places} places and is given {call.Facts} facts";

        Assert.Empty(wrong);
    }

    [Theory]
    [MemberData(nameof(Projects))]
    public void Every_text_is_asked_for(string project)
    {
        var sources = string.Join('\n', Sources(project).Select(file => file.Text)) + (project == "App" ? string.Join('\n', SourceFile.Under("src/Engraver.App", ".axaml").Select(file => file.Text)) : "");
        var composed = Composed().Matches(sources).SelectMany(start => start.Groups.Values.Skip(1)).Where(start => start.Success).Select(start => start.Value).ToHashSet();
        var unused = Texts(project).Keys.Where(name => !sources.Contains($"\"{name}\"", StringComparison.Ordinal) && !sources.Contains($"Say {name}}}", StringComparison.Ordinal)
            && !DiagnosticName().IsMatch(name) && !composed.Any(start => name.StartsWith(start, StringComparison.Ordinal)));

        Assert.Empty(unused);
    }

    [Theory]
    [MemberData(nameof(Projects))]
    public void No_fact_of_a_text_is_a_word_of_the_source(string project) =>
        Assert.Empty(Sources(project).SelectMany(file => Calls(file).Where(call => WordInFact().IsMatch(Noun().Replace(call.Given, ""))).Select(call => $"{file.Name}: {call.Name}{call.Given}")));

    [Theory]
    [MemberData(nameof(Projects))]
    public void No_source_has_more_sentences_than_it_is_known_for(string project)
    {
        var known = File.ReadAllLines(Path.Combine(RepositoryFolder.Root, ListName)).Where(line => line.Length > 0 && line[0] != '#').Select(line => line.Split(' ', 3)).ToDictionary(words => words[0], words => int.Parse(words[1], System.Globalization.CultureInfo.InvariantCulture));
        var found = Sources(project).Select(file => (file.Name, Sentences: Sentences(file).ToList())).Where(file => file.Sentences.Count != known.GetValueOrDefault(file.Name)).ToList();
        var gone = known.Keys.Where(name => name.StartsWith(Folder(project) + "/", StringComparison.Ordinal) && !Sources(project).Any(file => file.Name == name));

        Assert.True(found.Count == 0, $"Texts for people belong into Texts.resx. Where there are fewer than {ListName} says, lower the number there:\n{string.Join('\n', found.Select(file => $"{file.Name} {file.Sentences.Count} (known: {known.GetValueOrDefault(file.Name)})\n    {string.Join("\n    ", file.Sentences)}"))}");
        Assert.Empty(gone);
    }

    [Theory]
    [InlineData("""Say("Nothing was armed.")""")]
    [InlineData("""Say($"{count} lines, none of them cut")""")]
    [InlineData(""""x = """two words""";"""")]
    public void A_sentence_is_noticed(string code) => Assert.NotEmpty(Sentences(new SourceFile("src/P/One.cs", code)));

    [Theory]
    [InlineData("""Say("OPEN")""")]
    [InlineData("""// "two words" of a comment""")]
    [InlineData("""throw new ArgumentException("two words", nameof(x));""")]
    [InlineData("""var two = "a"; var words = "b";""")]
    public void What_is_no_sentence_is_not(string code) => Assert.Empty(Sentences(new SourceFile("src/P/One.cs", code)));

    [Theory]
    [InlineData("Wording.Get(\"A.B\")", 0)]
    [InlineData("Wording.Get(\"A.B\", Name(x, y), z ? \"1, 2\" : \"\")", 2)]
    [InlineData("Text.Get(\"A.B\", list[1, 2])", 1)]
    public void Facts_are_counted(string code, int facts) => Assert.Equal([facts], Calls(new SourceFile("src/P/One.cs", code)).Select(call => call.Facts));

    /// <summary>The engines in tools are compiled into several programs and have separate texts.</summary>
    private static string Folder(string project) => project == "tools" ? project : "src/Engraver." + project;

    private static IReadOnlyList<SourceFile> Sources(string project) => SourceFile.Under(Folder(project), ".cs");

    private static Dictionary<string, string> Texts(string project) =>
        XDocument.Load(Path.Combine(RepositoryFolder.Root, Folder(project), project == "App" ? "Texts" : "", "Texts.resx")).Root!.Elements("data").ToDictionary(data => data.Attribute("name")!.Value, data => data.Element("value")!.Value);

    private static int Places(string text) => Place().Matches(text).Select(place => int.Parse(place.Groups[1].Value, System.Globalization.CultureInfo.InvariantCulture) + 1).DefaultIfEmpty(0).Max();

    /// <summary>Calls that name their text; the arguments after the name are facts.</summary>
    private static IEnumerable<(string Name, int Facts, string Given)> Calls(SourceFile file)
    {
        var code = CSharpText.Parse(file.Text).Code;
        foreach (Match call in Call().Matches(file.Text))
        {
            if (code[call.Index] == ' ') continue;
            var (depth, facts, at) = (1, 0, call.Index + call.Length);
            for (; depth > 0; at++)
            {
                if (code[at] is '(' or '[' or '{') depth++;
                if (code[at] is ')' or ']' or '}') depth--;
                if (code[at] == ',' && depth == 1) facts++;
            }

            yield return (call.Groups[1].Value, facts, file.Text[(call.Index + call.Length)..at]);
        }
    }

    private static IEnumerable<string> Sentences(SourceFile file)
    {
        var parsed = CSharpText.Parse(file.Text);
        var texts = string.Concat(file.Text.Select((c, i) => char.IsWhiteSpace(c) || (parsed.Code[i] == ' ' && parsed.Comments[i] == ' ') ? c : '\u0001')).Split('\n');
        var lines = file.Text.Split('\n');
        return Enumerable.Range(0, lines.Length).Where(i => Sentence().IsMatch(texts[i]) && !OfABug().IsMatch(lines[i])).Select(i => $"{i + 1}: {lines[i].Trim()}");
    }

    [GeneratedRegex(@"\b(?:Wording|Text)\.Get\(""([A-Za-z0-9.-]+)""(?=\s*[,)])")]
    private static partial Regex Call();

    /// <summary>Composed names: how each begins ("State." + ..., $"Setting.{...}), or the name to which One and Many are appended.</summary>
    [GeneratedRegex(@"""([A-Z][A-Za-z]*\.)"" \+|\$""([A-Z][A-Za-z]*\.)\{|(?:Wording|Text)\.Count\(""([A-Za-z.]+)""")]
    private static partial Regex Composed();

    /// <summary>Names of nouns in the resources.</summary>
    [GeneratedRegex(@"CountText\.Format\([^""]*""[A-Za-z]+""\)")]
    private static partial Regex Noun();

    [GeneratedRegex(@"\{(\d+)[^{}]*\}")]
    private static partial Regex Place();

    [GeneratedRegex(@"^[A-Z]{3}\d{4}(\.Advice)?$")]
    private static partial Regex DiagnosticName();

    /// <summary>A text of letters that is an argument or one of two alternatives; names of texts and compared values are excluded.</summary>
    [GeneratedRegex(@"(?:, |\? |: )\$?""[^""{]*[a-z]{2}[^""]*""(?= :|,|\)|$)(?!,\s*StringComparison)")]
    private static partial Regex WordInFact();

    [GeneratedRegex(@"[A-Za-z]{2,}[,.;:]? [A-Za-z]{2,}")]
    private static partial Regex Sentence();

    /// <summary>Messages of internal errors, which developers read, and attributes for the compiler.</summary>
    [GeneratedRegex(@"\b(Argument\w*|InvalidOperation|Unreachable|NotSupported|ObjectDisposed|MissingManifestResource|KeyNotFound)Exception\(|SuppressMessage\(|UnconditionalSuppress|JustificationFor")]
    private static partial Regex OfABug();
}
