namespace Engraver.Workbench.Commands;

/// <summary>A completion of what is typed: alias first where there is one, as in <c>M (MOVE)</c>.</summary>
/// <param name="Alias">Null for the command's own name.</param>
public sealed record CommandSuggestion(string? Alias, CommandInfo Command)
{
    public string Text => Alias is null ? Command.Name : $"{Alias} ({Command.Name})";
}
