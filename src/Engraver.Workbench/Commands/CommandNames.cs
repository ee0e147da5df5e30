using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>Finds the command of a typed name, alias or beginning of one.</summary>
internal static class CommandNames
{
    /// <summary>The command of a name or alias; null when there is none.</summary>
    public static ICommand? Find(string input, CommandCatalog catalog, AliasTable aliases)
    {
        var name = CommandWord.Bare(input);
        return catalog.Find(name) ?? (aliases.CommandOf(name) is { } meant ? catalog.Find(meant) : null);
    }

    /// <summary>Commands whose name or alias begins with what is typed; an alias that is meant exactly comes first.</summary>
    public static IReadOnlyList<CommandSuggestion> Suggest(string typed, CommandCatalog catalog, AliasTable table)
    {
        var name = CommandWord.Bare(typed);
        if (name.Length == 0) return [];
        var aliases = table.Commands
            .Where(pair => pair.Key.StartsWith(name, StringComparison.OrdinalIgnoreCase))
            .OrderBy(pair => pair.Key.Length).ThenBy(pair => pair.Key, StringComparer.Ordinal)
            .Select(pair => (Alias: pair.Key, Command: catalog.Find(pair.Value)))
            .Where(pair => pair.Command is not null)
            .Select(pair => new CommandSuggestion(pair.Alias, pair.Command!.Info));
        var names = catalog.All.Where(info => info.Name.StartsWith(name, StringComparison.OrdinalIgnoreCase)).Select(info => new CommandSuggestion(null, info));
        return [.. aliases, .. names];
    }
}

/// <summary>A completion of what is typed: alias first where there is one, as in <c>M (MOVE)</c>.</summary>
/// <param name="Alias">Null for the command's own name.</param>
public sealed record CommandSuggestion(string? Alias, CommandInfo Command)
{
    public string Text => Alias is null ? Command.Name : $"{Alias} ({Command.Name})";
}

/// <summary>A typed command name without AutoCAD's prefixes: <c>'</c> transparent, <c>_</c> international, <c>.</c> built-in, <c>-</c> without a dialog (there are none here).</summary>
internal static class CommandWord
{
    public static string Bare(string typed) => typed.TrimStart('\'', '_', '.', '-');
}
