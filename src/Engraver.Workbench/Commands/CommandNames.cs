using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Machine;

namespace Engraver.Workbench.Commands;

/// <summary>Finds commands by name, alias or prefix.</summary>
internal static class CommandNames
{
    /// <summary>The command with this name or alias; null when there is none.</summary>
    public static ICommand? Find(string input, CommandCatalog catalog, AliasTable aliases)
    {
        var name = CommandPrefix.WithoutPrefix(input);
        return catalog.Find(name) ?? (aliases.CommandOf(name) is { } meant ? catalog.Find(meant) : null);
    }

    /// <summary>All commands that match: aliases that start with the input (an exact match first), then names that start with it (CNCSTOP before the other CNC
    /// commands), then names that contain it.</summary>
    public static IReadOnlyList<CommandSuggestion> Suggest(string typed, CommandCatalog catalog, AliasTable table)
    {
        var name = CommandPrefix.WithoutPrefix(typed);
        if (name.Length == 0) return [];
        var aliases = table.Commands
            .Where(pair => pair.Key.StartsWith(name, StringComparison.OrdinalIgnoreCase))
            .OrderBy(pair => pair.Key.Length).ThenBy(pair => pair.Key, StringComparer.Ordinal)
            .Select(pair => (Alias: pair.Key, Command: catalog.Find(pair.Value)))
            .Where(pair => pair.Command is not null)
            .Select(pair => new CommandSuggestion(pair.Alias, pair.Command!.Info));
        var names = catalog.All.Where(info => info.Name.StartsWith(name, StringComparison.OrdinalIgnoreCase)).Select(info => new CommandSuggestion(null, info));
        var inside = catalog.All.Where(info => info.Name.IndexOf(name, StringComparison.OrdinalIgnoreCase) > 0).Select(info => new CommandSuggestion(null, info));
        return [.. aliases, .. names.OrderByDescending(IsStop), .. inside];

        static bool IsStop(CommandSuggestion suggestion) => suggestion.Command.Name == CncStopCommand.Name; // CNC typed in a hurry most likely means CNCSTOP.
    }
}
