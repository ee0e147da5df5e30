using System.Xml.Linq;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Commands;

public class CatalogTests
{
    [Fact]
    public void Every_command_that_is_built_is_in_the_catalogue_and_says_what_it_does()
    {
        var catalog = CommandCatalog.Built();
        var listed = catalog.All.Select(info => catalog.Find(info.Name)!.GetType()).ToHashSet();
        var built = typeof(ICommand).Assembly.GetTypes().Where(type => type is { IsClass: true, IsAbstract: false } && typeof(ICommand).IsAssignableFrom(type));

        Assert.All(built, type => Assert.Contains(type, listed));
        Assert.All(catalog.All, info => Assert.Matches("^[A-Z0-9][^\n]+\\.$", info.Summary));
        Assert.All(catalog.All, info => Assert.Equal(info.Name.ToUpperInvariant(), info.Name));
    }

    [Fact]
    public void Every_command_has_a_text_for_the_menus_and_no_two_have_the_same()
    {
        var texts = XDocument.Load(Path.Combine(RepositoryFolder.Root, "src", "Engraver.App", "Texts", "Texts.resx")).Descendants("data").ToDictionary(data => data.Attribute("name")!.Value, data => data.Element("value")!.Value);
        string? TitleOf(string name) => texts.GetValueOrDefault($"Command.{name}") ?? SettingTable.All.FirstOrDefault(setting => setting.Command == name)?.Name;
        var names = CommandCatalog.Built().All.Select(info => info.Name).ToList();

        Assert.DoesNotContain(names, name => TitleOf(name) is null);
        Assert.Distinct(names.Select(TitleOf));
    }

    [Fact]
    public async Task Every_short_name_stands_for_a_command_and_none_of_a_letter_or_two_moves_anything()
    {
        await using var talk = new CommandTestSession();
        Assert.All(talk.Session.Aliases.Commands, pair => Assert.NotNull(talk.Session.Catalog.Find(pair.Value)));
        Assert.DoesNotContain(talk.Session.Aliases.Commands, pair => pair.Key.Length < 3 && talk.Session.Catalog.Find(pair.Value)!.Info.StartsMotion);
    }

    [Fact]
    public async Task Where_a_hand_starts_it_must_arm_first_and_a_script_is_asked_on_a_simulated_controller()
    {
        var folder = Directory.CreateTempSubdirectory("engraver-arm-");
        try
        {
            var environment = new CommandEnvironment { Folder = folder.FullName, RunJournalFolder = folder.FullName, RunNeedsArming = true };
            await using var session = new CommandSession(environment, CommandCatalog.Built());
            session.Document.Commit("OPEN", new Engraver.Workbench.Documents.DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 5, 0).Build() });
            await File.WriteAllTextAsync(Path.Combine(folder.FullName, "a.scr"), "CNCRUN\nYes\n");
            foreach (var input in new[] { "CNCCONNECT", "sim:" }) await session.EnterAsync(input, CancellationToken.None);

            Assert.Contains("CNCARM", Assert.IsType<InputResult.Failed>(await session.EnterAsync("CNCRUN", CancellationToken.None)).Message, StringComparison.Ordinal);
            await session.EnterAsync("SCRIPT", CancellationToken.None);
            Assert.IsType<InputResult.Done>(await session.EnterAsync("a.scr", CancellationToken.None));
            Assert.NotNull(session.Machine.Runs.LastRun);
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }
}
