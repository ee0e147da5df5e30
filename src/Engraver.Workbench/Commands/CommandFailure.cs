namespace Engraver.Workbench.Commands;

/// <summary>Why a command did not do what it should; the runner turns each into its exit code.</summary>
public enum CommandFailure
{
    /// <summary>The drawing is unusable, or has errors that prevent the command.</summary>
    Drawing,

    /// <summary>Wrong or missing input, a file that cannot be written, nothing open.</summary>
    Usage,

    /// <summary>The controller refused.</summary>
    Refused,

    /// <summary>The link was lost or never came up.</summary>
    LinkLost,

    /// <summary>The operator stopped the machine.</summary>
    Stopped,

    /// <summary>A bug. A job under way was stopped; the session goes on.</summary>
    Internal,
}
