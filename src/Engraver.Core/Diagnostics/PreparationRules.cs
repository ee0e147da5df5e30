namespace Engraver.Core.Diagnostics;

/// <summary>Findings before a job is run, when not everything visible is cut or it would be cut in another place. Lengths in the sentences are millimetres.</summary>
public static class PreparationRules
{
    public static readonly DiagnosticRule NotCut = new("JOB0001", Severity.Warning, "counts", "are");

    public static readonly DiagnosticRule NotLevel = new("JOB0002", Severity.Warning, "curves", "low", "high");

    public static readonly DiagnosticRule SeveralHeights = new("JOB0003", Severity.Warning, "count", "low", "high");

    public static readonly DiagnosticRule OneHeight = new("JOB0004", Severity.Info, "z");

    public static readonly DiagnosticRule TooLarge = new("JOB0005", Severity.Warning, "width", "height", "distance", "size", "far", "guess");

    public static readonly DiagnosticRule StartsElsewhere = new("JOB0006", Severity.Warning, "here", "start", "when", "there", "dx", "dy");

    public static readonly DiagnosticRule StartNotKept = new("JOB0007", Severity.Warning, "reason");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [NotCut, NotLevel, SeveralHeights, OneHeight, TooLarge, StartsElsewhere, StartNotKept];
}
