using Engraver.Workbench.Commands;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Settings;

/// <summary>The OPTIONS page shows the settings of the tables.</summary>
public sealed class OptionTableTests
{
    [Fact]
    public async Task Every_setting_and_every_system_variable_stands_on_one_page()
    {
        await using var talk = new CommandTestSession();
        var entries = OptionTable.Of(talk.Session);

        Assert.Equal(entries.Count, entries.Select(entry => entry.Key).Distinct().Count());
        Assert.Equal(SettingTable.All.Where(setting => setting.Page is not null).Select(setting => setting.Key).Order(StringComparer.Ordinal), entries.Select(entry => entry.Key).Where(key => char.IsLower(key[0])).Order(StringComparer.Ordinal));
        var commands = talk.Session.Catalog.All.Where(info => info.Group == CommandGroup.Setting).Select(info => info.Name);
        Assert.Empty(commands.Except(entries.Select(entry => entry.Command)));
        Assert.All(entries, entry => Assert.NotNull(talk.Session.Catalog.Find(entry.Command)));
        Assert.All(entries, entry => Assert.DoesNotContain('[', entry.Meaning));
        Assert.All(entries, entry => Assert.True(entry.PageTitle.Length > 0 && entry.Name.Length > 0 && entry.Meaning.EndsWith('.'), entry.Key));
    }

    /// <summary>Each displayed value is accepted by its command and remains unchanged.</summary>
    [Fact]
    public async Task Every_value_that_is_shown_is_taken_by_the_command_of_its_setting()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var entries = OptionTable.Of(talk.Session);
        var shown = entries.ToDictionary(entry => entry.Key, entry => entry.Value);
        foreach (var entry in entries.Where(entry => entry.Value.Length > 0))
        {
            Assert.Null(entry.RefusalOf(entry.Value));
            var result = await talk.TypeAsync([.. OptionTable.InputsFor(entry, shown)]);
            Assert.True(result is InputResult.Done, $"{entry.Key} {entry.Value}: {result}");
        }

        Assert.Equal(shown, OptionTable.Of(talk.Session).ToDictionary(entry => entry.Key, entry => entry.Value));
    }

    [Fact]
    public async Task A_wrong_value_is_refused_in_the_words_of_the_command()
    {
        await using var talk = new CommandTestSession();
        foreach (var entry in OptionTable.Of(talk.Session).Where(entry => entry.Choices.Count == 0 && entry.Command != "KERF"))
        {
            foreach (var typed in new[] { "x", "1e300" })
            {
                await talk.TypeAsync(entry.Command);
                var refused = Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync(typed));
                Assert.Equal(refused.Message, entry.RefusalOf(typed));
                await talk.Session.CancelAsync();
            }
        }
    }
}
