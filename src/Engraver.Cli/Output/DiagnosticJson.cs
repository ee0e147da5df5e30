using Engraver.Core.Diagnostics;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Output;

/// <summary>A diagnostic in the runner's JSON.</summary>
internal sealed record DiagnosticJson(string Id, string Severity, long Line, string? Handle, string Message)
{
    public static DiagnosticJson From(Diagnostic diagnostic) =>
        new(diagnostic.Id, DiagnosticTable.SeverityWord(diagnostic.Severity), diagnostic.Source.Line, diagnostic.Source.Handle, SettingWording.OnConsole(diagnostic).Message);
}
