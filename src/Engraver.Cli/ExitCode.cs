using Engraver.Core.Machines;

namespace Engraver.Cli;

/// <summary>The exit codes of the runner's contract; scripts rely on them.</summary>
public static class ExitCode
{
    public const int Done = 0;

    /// <summary>A diagnostic of severity error: file unusable or truncated, or a curve lost; or what was cut is not the drawing.</summary>
    public const int DrawingError = 1;

    /// <summary>Unknown verb, option or unreadable value.</summary>
    public const int Usage = 2;

    /// <summary>The controller refused a command.</summary>
    public const int Refused = 3;

    /// <summary>The link was lost or never came up.</summary>
    public const int LinkLost = 4;

    public const int StoppedByOperator = 5;

    /// <summary>A bug; a crash report is written.</summary>
    public const int InternalError = 70;

    /// <summary>How a job or a move ended.</summary>
    public static int Of(JobOutcome outcome) => outcome switch
    {
        JobOutcome.Complete => Done,
        JobOutcome.Stopped => StoppedByOperator,
        JobOutcome.Refused => Refused,
        JobOutcome.Deviated => DrawingError,
        _ => LinkLost,
    };
}
