using Engraver.Core.Diagnostics;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands;

/// <summary>Writes the findings of the stages, worst first.</summary>
internal static class FindingMessages
{
    public static void Write(CommandContext context, string file, IEnumerable<Diagnostic> diagnostics, Severity minSeverity)
    {
        foreach (var found in diagnostics.Where(found => found.Severity >= minSeverity).OrderByDescending(found => found.Severity))
        {
            var kind = found.Severity switch { Severity.Error => MessageKind.Error, Severity.Warning => MessageKind.Warning, _ => MessageKind.Note };
            context.WriteMessage(DiagnosticLine.Format(file, SettingWording.AtCommandLine(found)), kind);
        }
    }
}
