namespace Engraver.Core.Diagnostics;

/// <summary>Findings about a faults file, which lists the faults that a simulated controller shows deliberately.</summary>
public static class FaultFileRules
{
    public static readonly DiagnosticRule NoJson = new("FLT0001", Severity.Error, "reason");

    public static readonly DiagnosticRule FieldUnknown = new("FLT0002", Severity.Error, "field", "nearest");

    public static readonly DiagnosticRule ValueUnreadable = new("FLT0003", Severity.Error, "field", "expected");

    public static readonly DiagnosticRule FaultUnusable = new("FLT0004", Severity.Error, "fault", "reason");

    /// <summary>Every rule of this table, in order of id.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [NoJson, FieldUnknown, ValueUnreadable, FaultUnusable];
}
