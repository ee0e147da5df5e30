namespace Engraver.Workbench.Commands;

/// <summary>A completion of the input, with the alias first if there is one, as in <c>M (MOVE)</c>.</summary>
/// <param name="Alias">Null for the command's own name.</param>
public sealed record CommandSuggestion(string? Alias, CommandInfo Command)
{
    public string Text => Alias is null ? Command.Name : $"{Alias} ({Command.Name})";
}
