namespace Engraver.Workbench.Terminals;

/// <summary>What the terminal shows.</summary>
/// <param name="Kind">Decides the colour.</param>
/// <param name="Text">One line or more, LF between them.</param>
public readonly record struct TerminalAnswer(TerminalAnswerKind Kind, string Text);
