namespace Engraver.Core.Diagnostics;

/// <summary>The findings of offsets. Lengths in the sentences are millimetres.</summary>
public static class OffsetRules
{
    public static readonly DiagnosticRule WithoutInside = new("OFF0001", Severity.Warning, "count");

    public static readonly DiagnosticRule NothingLeft = new("OFF0002", Severity.Warning, "distance");

    public static readonly DiagnosticRule NotClosed = new("OFF0003", Severity.Error, "x", "y", "count");

    public static readonly DiagnosticRule NoInside = new("OFF0004", Severity.Error);

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [WithoutInside, NothingLeft, NotClosed, NoInside];
}
