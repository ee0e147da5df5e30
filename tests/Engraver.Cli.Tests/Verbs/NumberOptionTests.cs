using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>Every option that is one number, of every verb: a value that is not one number is refused with a sentence that names the option, before
/// anything happens.</summary>
public class NumberOptionTests
{
    /// <summary>Values with a comma, from an unset shell variable, with a unit or a typing error.</summary>
    private static readonly string[] s_unreadable = ["1,5", "1,000", "1,000,5", "", " ", "NaN", "nan", "Infinity", "-Infinity", "inf", "∞", "1e300", "-1e300", "1e999", "5mm", "5 mm", "0x10", "1..5", "1.5.5", "--5", "1e", "¼", "٣", "(5)", "$5", "5%"];

    public static TheoryData<string, string> Options()
    {
        var data = new TheoryData<string, string>();
        foreach (var (words, option) in All(Root(), "")) data.Add(words, option.Name);
        return data;
    }

    [Theory]
    [MemberData(nameof(Options))]
    public void One_number_is_read_strictly(string verb, string option)
    {
        Assert.Empty(s_unreadable.Where(word => !Refuses(verb, option, $"{option}={word}")).Select(word => $"taken: {option}={word}"));
        Assert.True(Refuses(verb, option, $"{option}=1", $"{option}=2"), "taken twice");
    }

    [Fact]
    public void All_options_that_are_one_number_are_tried()
    {
        var names = All(Root(), "").Select(entry => $"{entry.Words} {entry.Option.Name}").ToList();
        foreach (var known in (string[])["jog --x", "jog --feed", "zero --height", "run --lead-in", "run --feed", "pocket --tool", "desktop --scale", "simulate --speed", "simulate --decode", "trajectory --passes", "history --last"]) Assert.Contains(known, names);
    }

    [Theory]
    [InlineData("--x=1,5")]
    [InlineData("--x=1,000,5")]
    [InlineData("--y=NaN")]
    [InlineData("--feed=1,5")]
    public async Task A_jog_that_cannot_be_read_moves_nothing(string option)
    {
        var run = await CliRun.RunAsync("jog", "--connect", "sim:", "--x=1", option);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Empty(run.Out);
        Assert.Contains(option.Split('=')[0], run.Error, StringComparison.Ordinal);
    }

    /// <summary>Options of posts are texts for the library; those that accept 1 accept numbers.</summary>
    [Fact]
    public void Numbers_of_posts_are_read_strictly()
    {
        var numbers = PostTable.All.SelectMany(entry => entry.Post.Options).Where(option => option.IsValid("1") && !option.IsValid("x")).ToList();
        Assert.NotEmpty(numbers);
        foreach (var option in numbers) Assert.All(s_unreadable.Where(word => word.Length > 0), word => Assert.False(option.IsValid(word), $"{option.Name} takes {word}"));
    }

    private static bool Refuses(string verb, string option, params string[] words) =>
        Root().Parse([.. verb.Split(' '), .. words]).Errors.Any(error => error.Message.Contains(option, StringComparison.Ordinal));

    private static IEnumerable<(string Words, Option Option)> All(Command command, string path)
    {
        foreach (var option in command.Options)
        {
            var isNumber = (Nullable.GetUnderlyingType(option.ValueType) ?? option.ValueType) is { IsPrimitive: true } type && type != typeof(bool);
            if (path.Length > 0 && (isNumber || IsNumberSetting(option))) yield return (path, option);
        }

        foreach (var (words, option) in command.Subcommands.SelectMany(verb => All(verb, path.Length == 0 ? verb.Name : $"{path} {verb.Name}"))) yield return (words, option);
    }

    private static RootCommand Root() => EngraverCommandLine.Build(new ConsoleStreams(Stream.Null, TextWriter.Null, TextReader.Null), new GlobalOptions(), new ConnectionGuard());

    /// <summary>An option of a setting is a text, which the setting reads.</summary>
    private static bool IsNumberSetting(Option option) => SettingTable.All.Any(setting => setting is NumberSetting && setting.Option == option.Name);
}
