using Engraver.Core.Machines;

namespace Engraver.Cli;

/// <summary>The exit codes of the runner's contract; scripts rely on them.</summary>
public static class ExitCode
{
    public const int Done = 0;

    /// <summary>A diagnostic of severity error: the file is unusable or truncated, a curve was lost, or the cut differs from the drawing.</summary>
    public const int DrawingError = 1;

    /// <summary>Unknown verb, option or unreadable value.</summary>
    public const int Usage = 2;

    /// <summary>The controller refused a command.</summary>
    public const int Refused = 3;

    /// <summary>The link was lost or could not be established.</summary>
    public const int LinkLost = 4;

    public const int StoppedByOperator = 5;

    /// <summary>Internal error; a crash report is written.</summary>
    public const int InternalError = 70;

    /// <summary>The exit code for the outcome of a job or a move.</summary>
    public static int Of(JobOutcome outcome) => outcome switch
    {
        _ when outcome.IsAsPlanned() => Done,
        JobOutcome.Stopped => StoppedByOperator,
        JobOutcome.Refused => Refused,
        JobOutcome.Deviated => DrawingError,
        _ => LinkLost,
    };
}
