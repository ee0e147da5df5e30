namespace Engraver.Core.Machines;

/// <summary>A reply as the terminal shows it.</summary>
/// <param name="Kind">Decides the colour.</param>
/// <param name="Text">One or more lines, separated by LF.</param>
public readonly record struct TerminalAnswer(TerminalAnswerKind Kind, string Text);
