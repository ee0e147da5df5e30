namespace Engraver.Core.Machines;

/// <summary>A reply as the terminal shows it.</summary>
/// <param name="Kind">Decides the colour.</param>
/// <param name="Text">One or more lines, separated by LF.</param>
public readonly record struct TerminalAnswer(TerminalAnswerKind Kind, string Text);

/// <summary>The origin of a line in the terminal.</summary>
public enum TerminalAnswerKind : byte
{
    /// <summary>The controller's data, or its prompt when it returned none.</summary>
    Reply,

    /// <summary>The controller refused the command.</summary>
    Refusal,

    /// <summary>A program in the controller printed it.</summary>
    Message,

    /// <summary>Text of the terminal itself: help, history.</summary>
    Help,

    /// <summary>The terminal did not send the command.</summary>
    Withheld,
}
