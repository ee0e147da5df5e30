using System.Text.Json;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Languages;

/// <summary>Compares the file of each language other than English with the <c>Texts.resx</c> of every project: the keys are the same, and every fact is
/// used.</summary>
public sealed partial class LanguageFileTests
{
    private const int WordsOfASentence = 4;

    private static readonly string s_root = RepositoryFolder.Root;
    private static readonly string[] s_ofOtherTables = ["Keyword/", "Language/"];

    public static TheoryData<string> Files => [.. Directory.EnumerateFiles(Path.Combine(s_root, "src", "Engraver.Core", "Languages", "Texts"), "*.json").Select(file => Path.GetFileName(file))];

    [Fact]
    public void German_is_there() => Assert.True(File.Exists(Path.Combine(s_root, "src", "Engraver.Core", "Languages", "Texts", "de.json")));

    [Theory]
    [MemberData(nameof(Files))]
    public void Every_text_of_every_project_is_in_the_file_and_no_other(string file)
    {
        var (english, texts) = (English(), Read(file));
        Assert.InRange(english.Count, 2500, 100000);
        var missing = english.Keys.Except(texts.Keys).Select(key => $"missing: {key}");
        var left = texts.Keys.Except(english.Keys).Where(key => !s_ofOtherTables.Any(key.StartsWith)).Select(key => $"of no project: {key}");
        AssertNone(missing.Concat(left));
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void Every_fact_has_its_place_and_every_key_of_a_setting_stays(string file)
    {
        var (english, texts) = (English(), Read(file));
        AssertNone(from text in texts
                   where english.ContainsKey(text.Key) && (!Places(text.Value).SequenceEqual(Places(english[text.Key])) || !Keys(text.Value).SequenceEqual(Keys(english[text.Key])))
                   select $"{text.Key}: '{text.Value}' has other places than '{english[text.Key]}'");
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void No_text_is_empty_and_blanks_and_full_stops_at_its_ends_are_those_of_the_English_one(string file)
    {
        var (english, texts) = (English(), Read(file));
        AssertNone(from text in texts
                   where english.ContainsKey(text.Key) && Ends(text.Value) != Ends(english[text.Key])
                   select $"{text.Key}: '{text.Value}' begins or ends otherwise than '{english[text.Key]}'");
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void No_sentence_was_left_in_English(string file)
    {
        var (english, texts) = (English(), Read(file));
        AssertNone(from text in texts
                   where english.GetValueOrDefault(text.Key) == text.Value && Words().Count(text.Value) >= WordsOfASentence
                   select $"{text.Key}: {text.Value}");
    }

    [Fact]
    public void A_text_that_lacks_a_place_is_told() => Assert.False(Places("Zeile {0}").SequenceEqual(Places("line {0} of {1:0.0}")));

    private static (bool, bool, bool, int) Ends(string text) =>
        (text.Length > 0 && char.IsWhiteSpace(text[0]), text.Length > 0 && char.IsWhiteSpace(text[^1]), text.TrimEnd().EndsWith('.'), string.IsNullOrWhiteSpace(text) ? 0 : 1);

    private static IEnumerable<string> Places(string text) => Place().Matches(text).Select(match => match.Value).Order(StringComparer.Ordinal);

    private static IEnumerable<string> Keys(string text) => Key().Matches(text).Select(match => match.Value).Order(StringComparer.Ordinal);

    /// <summary>The texts of every project by <c>Project/Name</c>.</summary>
    private static Dictionary<string, string> English() =>
        (from file in Directory.EnumerateFiles(Path.Combine(s_root, "src"), "Texts.resx", SearchOption.AllDirectories).Append(Path.Combine(s_root, "tools", "Texts.resx"))
         let project = Path.GetRelativePath(s_root, file).Split(Path.DirectorySeparatorChar) is ["src", var folder, ..] ? folder["Engraver.".Length..] : "Tools"
         from data in XDocument.Load(file).Root!.Elements("data")
         select ($"{project}/{data.Attribute("name")!.Value}", data.Element("value")!.Value)).ToDictionary();

    private static Dictionary<string, string> Read(string file) =>
        JsonSerializer.Deserialize<Dictionary<string, string>>(File.ReadAllText(Path.Combine(s_root, "src", "Engraver.Core", "Languages", "Texts", file)))!;

    private static void AssertNone(IEnumerable<string> wrong)
    {
        var all = wrong.Order(StringComparer.Ordinal).ToList();
        Assert.True(all.Count == 0, $"{all.Count}:\n" + string.Join('\n', all.Take(60)));
    }

    [GeneratedRegex(@"\{\d+[^}]*\}")]
    private static partial Regex Place();

    [GeneratedRegex(@"\[[^\]]*\]")]
    private static partial Regex Key();

    [GeneratedRegex("[a-z]{3,}")]
    private static partial Regex Words();
}
