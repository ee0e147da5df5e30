using System.Globalization;
using System.Text;
using Engraver.TestKit;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>docs/commands.md is the catalogue of commands and the file of aliases.</summary>
public class CommandPageTests
{
    [Fact]
    public void The_page_of_commands_is_the_catalogue() => GoldenFile.Check(Path.Combine(RepositoryFolder.Root, "docs", "commands.md"), Page());

    private static string Page()
    {
        var catalog = CommandCatalog.Built();
        var aliases = AliasFiles.Read(userFile: null, catalog).Commands.ToLookup(alias => alias.Value, alias => alias.Key);
        var page = new StringBuilder();
        page.Append(CultureInfo.InvariantCulture, $"""
            # Commands

            This page is generated from the {catalog.All.Count()} commands of the program (`./test --update-golden`).
            Type them at the command line of the desktop, choose them from its menus, or write them into a script (`engraver script FILE.scr`).

            * **Aliases** are AutoCAD's. Your own go into `engraver.pgp` in your data folder.
            * `'`: can be used inside another command, with an apostrophe (`'ZOOM`).
            * `!`: can move the machine. Enter never repeats it, and it has no alias shorter than three letters.

            """);
        foreach (var group in catalog.All.GroupBy(info => info.Group))
        {
            page.Append(CultureInfo.InvariantCulture, $"\n## {Title(group.Key)}\n\n| Command | Alias | | What it does |\n|---|---|---|---|\n");
            foreach (var info in group) page.Append(CultureInfo.InvariantCulture, $"| `{info.Name}` | {string.Join(", ", aliases[info.Name].Order(StringComparer.Ordinal).Select(alias => $"`{alias}`"))} | {(info.IsTransparent ? "'" : "")}{(info.StartsMotion ? "!" : "")} | {info.Summary.Replace("|", "\\|", StringComparison.Ordinal)} |\n");
        }

        return page.ToString();
    }

    private static string Title(CommandGroup group) => group switch
    {
        CommandGroup.File => "Files and session",
        CommandGroup.View => "View",
        CommandGroup.Ask => "Inquiry",
        CommandGroup.Drawing => "Drawing and editing",
        CommandGroup.Sequence => "Sequence",
        CommandGroup.Trajectory => "Trajectories",
        CommandGroup.Output => "Programs and reports",
        CommandGroup.Machine => "Machine",
        CommandGroup.Setting => "Settings and system variables",
        _ => throw new ArgumentOutOfRangeException(nameof(group), group, "This group has no title."),
    };
}
