using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines.Terminals;

/// <summary>A line of the terminal's page.</summary>
/// <param name="Time">Time of input or reception.</param>
/// <param name="Kind">Null for input of the operator; otherwise the source.</param>
public sealed record TerminalEntry(DateTimeOffset Time, TerminalAnswerKind? Kind, string Text);
