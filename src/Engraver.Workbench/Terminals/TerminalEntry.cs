namespace Engraver.Workbench.Terminals;

/// <summary>A line of the terminal's page.</summary>
/// <param name="Time">When it was typed or heard.</param>
/// <param name="Kind">Null for what the operator typed; otherwise where it comes from.</param>
public sealed record TerminalEntry(DateTimeOffset Time, TerminalAnswerKind? Kind, string Text);
