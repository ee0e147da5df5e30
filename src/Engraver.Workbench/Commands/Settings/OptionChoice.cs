namespace Engraver.Workbench.Commands.Settings;

/// <summary>A word that may be chosen.</summary>
/// <param name="Value">As commands know it.</param>
/// <param name="Word">As it is shown.</param>
public sealed record OptionChoice(string Value, string Word);
