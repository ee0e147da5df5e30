namespace Engraver.Workbench.Commands;

public enum MessageKind
{
    /// <summary>A prompt and what was typed to it.</summary>
    Echo,

    /// <summary>What a command was asked for: figures, lists, program text.</summary>
    Result,

    /// <summary>What a command has to say besides.</summary>
    Note,

    Warning,

    /// <summary>A finding of severity error, or an input that was not understood.</summary>
    Error,
}
