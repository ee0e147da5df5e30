using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.TestKit;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Tests.Options;

/// <summary>Every setting of the table that has an option has it at every drawing verb, with its help, its page and its completion.</summary>
public sealed class SettingOptionTests
{
    private static readonly string[] s_texts = ["1", "0.5", "A1", "1,2", "0,0:1,1", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), Path.Combine(RepositoryFolder.Samples, "operation-plate.operations.json")];

    public static TheoryData<string> Keys => [.. SettingTable.All.Where(setting => setting.HasOption).Select(setting => setting.Key)];

    [Theory]
    [MemberData(nameof(Keys))]
    public void Each_setting_is_read_from_its_option(string key)
    {
        var setting = SettingTable.Find(key)!;
        var read = setting.OptionWords.Concat(s_texts).Select(text => Read(setting, text)).First(settings => settings is not null && settings != DrawingSettings.Default)!;

        Assert.NotEqual(DrawingSettings.Default, read);
        Assert.Equal(DrawingSettings.Default, Read(null, null));
    }

    [Theory]
    [MemberData(nameof(Keys))]
    public void Each_option_has_its_help_its_place_on_the_page_and_its_completion(string key)
    {
        var setting = SettingTable.Find(key)!;
        var root = EngraverCommandLine.Build(new ConsoleStreams(Stream.Null, TextWriter.Null, TextReader.Null), new GlobalOptions(), new ConnectionGuard());
        var plan = root.Subcommands.Single(verb => verb.Name == "plan");
        var option = plan.Options.Single(one => one.Name == setting.Option);

        Assert.Equal(SettingWording.OnConsole(setting.Meaning), option.Description);
        Assert.Contains($"| `{setting.Option}` |", File.ReadAllText(Path.Combine(RepositoryFolder.Root, "docs", "verbs.md")), StringComparison.Ordinal);
        Assert.Contains(setting.Option, root.Parse("plan part.dxf --").GetCompletions().Select(one => one.Label));
        Assert.Superset(setting.OptionWords.ToHashSet(), root.Parse($"plan part.dxf {setting.Option} ").GetCompletions().Select(one => one.Label).ToHashSet());
    }

    [Fact]
    public void A_side_of_the_kerf_requires_a_tool_diameter() =>
        Assert.Equal("--kerf requires --tool-diameter.", Assert.Throws<UsageException>(() => Settings(["part.dxf", "--kerf", "left"])).Message);

    [Fact]
    public void The_feed_overrides_that_of_the_profile_wherever_it_is_given() =>
        Assert.Equal(300.0, Settings(["part.dxf", "--feed", "300", "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json")]).Machine.FeedMmPerMinute);

    /// <summary>The settings with one option; null when it is refused.</summary>
    private static DrawingSettings? Read(Setting? setting, string? text)
    {
        try
        {
            return Settings(setting is null ? ["part.dxf"] : setting.IsSwitch ? ["part.dxf", setting.Option!] : ["part.dxf", setting.Option!, text!, .. With(setting)]);
        }
        catch (Exception refused) when (refused is UsageException or SettingException)
        {
            return null;
        }
    }

    /// <summary>What the option is used together with.</summary>
    private static string[] With(Setting setting)
    {
        if (setting == SettingTable.Kerf) return ["--tool-diameter", "1"];
        if (setting == SettingTable.Tool) return ["--operations", s_texts[^1]];
        if (setting == SettingTable.Align) return ["--to", "0,0:1,1"];
        if (setting == SettingTable.To) return ["--align", "0,0:1,1"];
        return setting == SettingTable.Back ? ["--blank", "10,10"] : [];
    }

    private static DrawingSettings Settings(string[] arguments)
    {
        var (command, options) = (new Command("verb"), new DrawingOptions());
        options.AddTo(command);
        var parsed = command.Parse(arguments);
        return parsed.Errors.Count == 0 ? options.Settings(parsed) : throw new UsageException(parsed.Errors[0].Message);
    }
}
