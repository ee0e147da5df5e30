namespace Engraver.Workbench.Commands;

/// <summary>Why a command failed; the console runner maps each reason to an exit code.</summary>
public enum CommandFailure
{
    /// <summary>The drawing is unusable, or has errors that prevent the command.</summary>
    Drawing,

    /// <summary>Wrong or missing input, a file that cannot be written, nothing open.</summary>
    Usage,

    /// <summary>The controller refused a command.</summary>
    Refused,

    /// <summary>The link was lost or could not be established.</summary>
    LinkLost,

    /// <summary>The operator stopped the machine.</summary>
    Stopped,

    /// <summary>Internal error. A running job was stopped; the session continues.</summary>
    Internal,
}
