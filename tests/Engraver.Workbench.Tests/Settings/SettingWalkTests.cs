using System.Reflection;
using Engraver.Core.Sequencing;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Settings;

/// <summary>Everything that a setting has follows from its row of the table: a new row needs no entry anywhere else. Its option is tested in
/// <c>SettingOptionTests</c>.</summary>
public sealed class SettingWalkTests
{
    /// <summary>How the records that a stage receives its options in are named.</summary>
    private static readonly string[] s_options = ["Options", "Tolerances", "Request", "Terms"];

    public static TheoryData<string> Keys => [.. SettingTable.All.Select(setting => setting.Key)];

    [Theory]
    [MemberData(nameof(Keys))]
    public void Each_setting_has_its_texts_and_its_row_of_the_page(string key)
    {
        var setting = SettingTable.Find(key)!;
        var page = File.ReadAllLines(Path.Combine(RepositoryFolder.Root, "docs", "settings.md"));

        Assert.True(setting.Name.Length > 0 && setting.Meaning.EndsWith('.'));
        Assert.Single(page, line => line.StartsWith($"| {key} | {setting.Name} |", StringComparison.Ordinal));
        Assert.Equal($"--[{key}]", SettingWording.OnConsole($"--[{key}]").Replace(setting.Option ?? setting.Name, $"[{key}]", StringComparison.Ordinal));
        Assert.StartsWith(setting.Command, SettingWording.AtCommandLine($"[{key}]"), StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(Keys))]
    public void Each_setting_has_a_command(string key)
    {
        var setting = SettingTable.Find(key)!;
        var command = CommandCatalog.Built().Find(setting.Command);

        Assert.NotNull(command);
        Assert.Equal(setting.HasOwnCommand, command is not SettingCommand);
        Assert.True(setting.HasOwnCommand || setting.Choices.Count > 0 || setting.Max > setting.Min, "its command asks for a number without a range");
    }

    [Theory]
    [MemberData(nameof(Keys))]
    public async Task Each_setting_with_a_page_is_on_OPTIONS_and_changed_there(string key)
    {
        var setting = SettingTable.Find(key)!;
        await using var talk = CommandTestSession.WithDrawing();
        var entries = OptionTable.Of(talk.Session).Where(entry => entry.Key == key).ToList();
        Assert.Equal(setting.Page is null ? [] : [setting.Page.ToString()!], entries.Select(entry => entry.Page));
        if (setting.Page is null || setting.HasOwnCommand) return;

        var input = setting.ToInput(Another(setting));
        var shown = OptionTable.Of(talk.Session).ToDictionary(entry => entry.Key, entry => entry.Key == key ? input : entry.Value);
        Assert.Null(entries[0].RefusalOf(input));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync([.. OptionTable.InputsFor(entries[0], shown)]));
        Assert.Equal(input, setting.ToInput(talk.State.Settings));
        Assert.Equal(input, OptionTable.Of(talk.Session).Single(entry => entry.Key == key).Value);
    }

    [Theory]
    [MemberData(nameof(Keys))]
    public void Each_value_comes_back_from_the_words_of_files(string key)
    {
        var setting = SettingTable.Find(key)!;
        foreach (var settings in new[] { DrawingSettings.Default, Another(setting) })
        {
            var words = SettingValues.Of(settings);
            var back = SettingValues.Read(words, settings.Machine);

            Assert.Equal(setting.ToWord(settings), words.GetValueOrDefault(key));
            Assert.Equal(setting.ToInput(settings), setting.ToInput(back));
            Assert.Equal(words, SettingValues.Of(back));
        }
    }

    [Fact]
    public void Each_property_of_the_settings_is_changed_by_a_row_of_the_table()
    {
        var properties = typeof(DrawingSettings).GetProperties(BindingFlags.Public | BindingFlags.Instance).Where(property => property.CanWrite).ToList();
        var changed = SettingTable.All.SelectMany(setting => properties.Where(property => !Equals(property.GetValue(Another(setting)), property.GetValue(DrawingSettings.Default)))).Select(property => property.Name);

        Assert.Equal(properties.Select(property => property.Name).Order(StringComparer.Ordinal), changed.Distinct().Order(StringComparer.Ordinal));
    }

    /// <summary>The default of a setting is not repeated in an options record of Core: a caller that forgets the setting would silently get it.</summary>
    [Fact]
    public void No_record_of_Core_has_the_default_of_a_setting()
    {
        var defaults = SettingTable.All.OfType<NumberSetting>().Where(setting => setting is not MachineNumberSetting).Select(setting => setting.DefaultValue).Where(value => value != 0.0).ToList();
        var records = typeof(SequencingOptions).Assembly.GetTypes().Where(type => s_options.Any(end => type.Name.EndsWith(end, StringComparison.Ordinal)) && !type.IsAbstract && type.GetConstructor(Type.EmptyTypes) is not null).ToList();
        var repeated = from type in records
                       let made = Activator.CreateInstance(type)
                       from property in type.GetProperties(BindingFlags.Public | BindingFlags.Instance)
                       where property.PropertyType == typeof(double) && property.SetMethod is not null && property.GetValue(made) is double value && defaults.Contains(value)
                       select $"{type.Name}.{property.Name}";

        Assert.Contains(DrawingSettings.Default.MaxErrorMm, defaults);
        Assert.Contains(typeof(SequencingOptions), records);
        Assert.Empty(repeated);
    }

    /// <summary>The settings with another value of one of them.</summary>
    private static DrawingSettings Another(Setting setting)
    {
        string[] texts = ["1", .. setting.OptionWords, "0.5", "A1", "1,2", "0,0:1,1", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), Path.Combine(RepositoryFolder.Samples, "operation-plate.operations.json")];
        return setting.HasOption
            ? texts.Where(text => setting.WhyNotOption(text) is null).Select(text => TryOption(setting, text)).First(settings => settings is not null && settings != DrawingSettings.Default)!
            : setting.FromInput(DrawingSettings.Default, "2048");
    }

    private static DrawingSettings? TryOption(Setting setting, string text)
    {
        try
        {
            return setting.FromOption(DrawingSettings.Default, text, (_, _) => { });
        }
        catch (SettingException)
        {
            return null;
        }
    }
}
