namespace Engraver.Workbench.Commands;

public enum MessageKind
{
    /// <summary>A prompt and its input.</summary>
    Echo,

    /// <summary>The requested output of a command: figures, lists, program text.</summary>
    Result,

    /// <summary>Additional information from a command.</summary>
    Note,

    Warning,

    /// <summary>A finding of severity error, or invalid input.</summary>
    Error,
}
