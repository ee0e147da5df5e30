using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Languages;
using Engraver.TestKit;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Languages;

/// <summary>Options of prompts in another language: shown and accepted in that language and in English, for scripts and AutoCAD users.</summary>
public sealed partial class OptionLanguageTests
{
    private static readonly CultureInfo s_german = new("de");

    /// <summary>The options of every prompt that names them in the sources.</summary>
    public static TheoryData<string> Lists => [.. OptionsInSources().Select(options => string.Join('/', options)).Distinct().Order(StringComparer.Ordinal)];

    [Fact]
    public void The_sources_were_read() => Assert.InRange(Lists.Count, 40, 1000);

    [Theory]
    [MemberData(nameof(Lists))]
    public void Every_option_is_in_every_language_and_answers_to_it_and_to_English(string list) => Assert.All(LanguageFile.All, file => In(new CultureInfo(file.Code), () =>
    {
        var options = Keyword.List(list.Split('/'));
        foreach (var option in options)
        {
            Assert.True(file.Find(nameof(Keyword), option.Name) is not null, $"{file.Code}.json has no Keyword/{option.Name}.");
            foreach (var typed in new[] { option.Shown, string.Concat(option.Shown.Where(letter => char.IsUpper(letter) || char.IsAsciiDigit(letter))), option.Name, option.Abbreviation, "_" + option.Name })
            {
                if (typed.Length > 0) Assert.True(Keyword.Find(options, typed) == option, $"'{typed}' is not {option.Name} but {Keyword.Find(options, typed)?.Name} at [{string.Join('/', options.Select(one => one.Shown))}].");
            }
        }
    }));

    [Fact]
    public async Task A_prompt_speaks_German_and_takes_both_languages()
    {
        CultureInfo.CurrentUICulture = s_german; // flows with this task alone
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("THEME");
        Assert.Equal("Farbschema eingeben [Dunkel/Hell/Kontraststark] <Dunkel>:", talk.Session.Prompt.Text);
        await talk.TypeAsync("hell", "THEME", "_Dark", "THEME", "Light", "THEME", "");
        Assert.Equal(Workbench.Settings.DesktopTheme.Light, talk.Session.View.Current.Theme);
        await talk.TypeAsync("THEME", "grün");
        Assert.Contains("Dunkel, Hell, Kontraststark", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_colour_has_its_German_name_and_answers_to_both()
    {
        CultureInfo.CurrentUICulture = s_german;
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"));
        foreach (var (typed, shown, index) in new[] { ("Grün", "grün", 3), ("BLUE", "blau", 5), ("weiß", "weiß", 7), ("WEISS", "weiß", 7), ("9", "9", 9) })
        {
            await talk.TypeAsync("LAYER", "C", typed, "VENTS", "");
            var colour = talk.State.Drawing!.Layers.Single(layer => layer.Name == "VENTS").Colour;
            Assert.Equal((index, shown), (colour.Index, Workbench.Commands.Editing.ColourName.Format(colour)));
        }

        await talk.TypeAsync("LAYER", "C", "lila");
        Assert.Contains("(rot, gelb, grün, cyan, blau, magenta, weiß)", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task LANGUAGE_is_kept_and_Auto_forgets_it()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("LANGUAGE");
        Assert.Equal("Enter language [Auto/English/German] <Auto>:", talk.Session.Prompt.Text);
        await talk.TypeAsync("German");
        Assert.Equal("de", talk.Session.Settings.Current.Language);
        Assert.Contains("changes at the next start", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("LANGUAGE", "English");
        Assert.Equal("en", talk.Session.Settings.Current.Language);
        await talk.TypeAsync("LANGUAGE", "Auto");
        Assert.Null(talk.Session.Settings.Current.Language);
    }

    [Fact]
    public void Back_is_one_word_for_a_direction_and_another_for_a_step() => In(s_german, () =>
    {
        Assert.Equal("Hinten", new Keyword("Back").Shown);
        Assert.Equal("Zurück", (new Keyword("Back") { Context = "Step" }).Shown);
    });

    private static void In(CultureInfo culture, Action act)
    {
        var before = CultureInfo.CurrentUICulture;
        CultureInfo.CurrentUICulture = culture;
        try
        {
            act();
        }
        finally
        {
            CultureInfo.CurrentUICulture = before;
        }
    }

    private static IEnumerable<IReadOnlyList<string>> OptionsInSources()
    {
        var enums = new[] { typeof(Keyword).Assembly, typeof(LanguageFile).Assembly }.SelectMany(assembly => assembly.GetTypes()).Where(type => type.IsEnum).ToLookup(type => type.Name);
        foreach (var file in Directory.EnumerateFiles(Path.Combine(RepositoryFolder.Root, "src", "Engraver.Workbench"), "*.cs", SearchOption.AllDirectories))
        {
            foreach (Match call in ListOfOptions().Matches(File.ReadAllText(file)))
            {
                var options = Literal().Matches(call.Value).Select(match => match.Groups[1].Value).Where(IsOption)
                    .Concat(EnumNames().Matches(call.Value).SelectMany(match => enums[match.Groups[1].Value].SelectMany(Enum.GetNames))).Distinct().ToList();
                if (options.Count > 0) yield return options;
            }
        }
    }

    /// <summary>Words with a capital, and not names of commands.</summary>
    private static bool IsOption(string text) =>
        text == "?" || (text.All(char.IsAsciiLetterOrDigit) && text.Any(char.IsAsciiLetterUpper) && !(text.Length > 3 && !text.Any(char.IsAsciiLetterLower)));

    /// <summary>The options passed to a list, a prompt or an array of words.</summary>
    [GeneratedRegex("""(?:Keyword\.List|ShapePrompts\.\w+|ChoiceAsync)\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)|(?:string\[\] \w+ =|\?|:) \[(?:"\w+"|[\w ]+\? "\w+" : "\w+")(?:, (?:"\w+"|[\w ]+\? "\w+" : "\w+"))*\]""")]
    private static partial Regex ListOfOptions();

    [GeneratedRegex("\"([^\"]+)\"")]
    private static partial Regex Literal();

    [GeneratedRegex(@"GetNames<(\w+)>")]
    private static partial Regex EnumNames();
}
