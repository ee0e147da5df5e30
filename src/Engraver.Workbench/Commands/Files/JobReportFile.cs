using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports.Pages;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Files;

/// <summary>Writes the report page of a job, for REPORT and HISTORY.</summary>
internal static class JobReportFile
{
    public static async Task WriteAsync(CommandContext context, JobReportRequest request, string path, CancellationToken cancellation)
    {
        var report = await Task.Run(() => JobReport.Create(request, cancellation), cancellation).ConfigureAwait(false);
        OutputFile.Write(path, output => JobReportPage.Write(report, context.Time.LocalTimeZone, output));
        if (report.Run is { } run && context.History.Save(run with { Report = Path.GetFullPath(path) }) is { } failure) context.WriteMessage(Wording.Get("History.NotKept", failure), MessageKind.Warning);
        context.WriteMessage(Wording.Get("Report.Written", path), MessageKind.Result);
    }

    /// <summary>The report page of a history entry: its current drawing with the settings of that time.</summary>
    /// <exception cref="CommandException">The drawing can no longer be read.</exception>
    public static Task WriteAsync(CommandContext context, HistoryEntry entry, DrawingSettings settings, CancellationToken cancellation)
    {
        var drawing = DrawingFile.Open(entry.Drawing, settings, cancellation);
        if (DrawingFile.IsUnreadable(drawing)) throw new CommandException(CommandFailure.Drawing, Wording.Get("Report.DrawingUnreadable", entry.Drawing, drawing.Diagnostics[0].Message));
        var driver = MachineFamilies.DriverOf(settings.Machine);
        var strategy = driver.Strategies.FirstOrDefault(one => one.Key == entry.Mode) ?? driver.DefaultStrategy;
        var address = entry.Address is { } word && context.Families.TryParseAddress(word, out var known) ? known : null;
        var request = new JobReportRequest(drawing, settings, strategy, context.Time.GetUtcNow()) { Families = context.Families, Address = address, Run = entry, Journal = entry.Journal, Spell = SettingWording.AtCommandLine };
        return WriteAsync(context, request, JobReportPage.PathOf(entry.Drawing), cancellation);
    }
}
