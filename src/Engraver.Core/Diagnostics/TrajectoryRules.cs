namespace Engraver.Core.Diagnostics;

/// <summary>The findings of trajectories. Lengths in the sentences are millimetres.</summary>
public static class TrajectoryRules
{
    public static readonly DiagnosticRule ErrorNotKept = new("TRJ0001", Severity.Error, "error", "length", "x", "y");

    public static readonly DiagnosticRule LimitBroken = new("TRJ0002", Severity.Error, "file", "limit");

    public static readonly DiagnosticRule LineUnreadable = new("TRJ0003", Severity.Error, "line", "reason");

    public static readonly DiagnosticRule StepsTooLong = new("TRJ0004", Severity.Warning, "file", "bound", "error");

    public static readonly DiagnosticRule TooFast = new("TRJ0005", Severity.Warning, "file", "feed", "acceleration", "limit", "speed");

    public static readonly DiagnosticRule SourceEdited = new("TRJ0006", Severity.Warning, "count", "name");

    public static readonly DiagnosticRule HeightsNotRun = new("TRJ0007", Severity.Warning, "low", "high");

    public static readonly DiagnosticRule StepsRefused = new("TRJ0008", Severity.Error, "name", "bound", "error");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [ErrorNotKept, LimitBroken, LineUnreadable, StepsTooLong, TooFast, SourceEdited, HeightsNotRun, StepsRefused];
}
