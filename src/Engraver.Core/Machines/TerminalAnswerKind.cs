namespace Engraver.Core.Machines;

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
