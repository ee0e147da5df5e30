namespace Engraver.Core.Machines;

/// <summary>What the terminal shows.</summary>
/// <param name="Kind">Decides the colour.</param>
/// <param name="Text">One line or more, LF between them.</param>
public readonly record struct TerminalAnswer(TerminalAnswerKind Kind, string Text);

/// <summary>Where a line of the terminal comes from.</summary>
public enum TerminalAnswerKind : byte
{
    /// <summary>The controller's data, or its prompt when it has nothing to say.</summary>
    Reply,

    /// <summary>The controller refused the command.</summary>
    Refusal,

    /// <summary>A program in the controller printed it.</summary>
    Message,

    /// <summary>The terminal itself: help, history.</summary>
    Help,

    /// <summary>The terminal did not send the command.</summary>
    Withheld,
}
