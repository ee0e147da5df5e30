namespace Engraver.Core.Diagnostics;

/// <summary>The findings of the file beside a drawing (docs/sidecar.md).</summary>
public static class SidecarRules
{
    public static readonly DiagnosticRule Damaged = new("SID0001", Severity.Error, "file", "reason");

    public static readonly DiagnosticRule OtherVersion = new("SID0002", Severity.Error, "file", "version");

    public static readonly DiagnosticRule Unreadable = new("SID0003", Severity.Error, "file", "reason");

    public static readonly DiagnosticRule DrawingChanged = new("SID0004", Severity.Warning, "file");

    public static readonly DiagnosticRule SetAside = new("SID0005", Severity.Warning, "file", "aside");

    public static readonly DiagnosticRule OperationsNotRun = new("SID0006", Severity.Warning, "file", "reason");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [Damaged, OtherVersion, Unreadable, DrawingChanged, SetAside, OperationsNotRun];
}
