using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.Reports;

/// <summary>A diagnostic as text: <c>FILE(LINE): Severity ID: sentence</c>.</summary>
public static class DiagnosticLine
{
    public static string Format(string file, Diagnostic diagnostic)
    {
        var place = diagnostic.Source.Line > 0 ? FormattableString.Invariant($"{file}({diagnostic.Source.Line})") : file;
        var handle = diagnostic.Source.Handle is { } name ? Wording.Get("DiagnosticLine.Handle", name) : "";
        return Wording.Get("DiagnosticLine.Line", place, DiagnosticTable.SeverityWord(diagnostic.Severity), diagnostic.Id, diagnostic.Message, handle);
    }
}
