using Engraver.Core.Diagnostics;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Output;

/// <summary>Diagnostics for people, on standard error: <c>FILE(LINE): Severity ID: sentence</c>.</summary>
internal static class DiagnosticPrinter
{
    /// <summary>Prints those of at least the given severity, worst first, otherwise in the order found.</summary>
    public static void Print(TextWriter error, string file, IEnumerable<Diagnostic> diagnostics, Severity minSeverity)
    {
        foreach (var diagnostic in diagnostics.Where(d => d.Severity >= minSeverity).OrderByDescending(d => d.Severity)) error.WriteLine(DiagnosticLine.Format(file, SettingWording.OnConsole(diagnostic)));
    }
}
