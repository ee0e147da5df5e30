using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports.Pages;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Files;

/// <summary>REPORT: Writes the job of the drawing, with its last run, as a page for the browser and for printing.</summary>
internal sealed class ReportCommand : ICommand
{
    public CommandInfo Info { get; } = new("REPORT", CommandGroup.Output);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var (drawing, settings) = (context.Drawing, context.Document.Current.Settings);
        var usual = Path.GetFileName(JobReportPage.PathOf(drawing.FileName));
        var name = await context.ValueAsync(new FilePrompt(Wording.Get("Report.EnterFileName"), new FileWanted("report", true, ".html") { Suggested = Path.GetFullPath(JobReportPage.PathOf(drawing.FileName)) }) { Default = usual }).ConfigureAwait(false);
        var path = name == usual ? JobReportPage.PathOf(drawing.FileName) : context.FileToWrite(name);
        if (name != usual || !context.IsScripted) await ReplacePrompt.ConfirmAsync(context, path, name).ConfigureAwait(false);
        var request = new JobReportRequest(drawing, settings, context.Derivation.Strategy, context.Time.GetUtcNow()) { Families = context.Families, Address = context.Machine.Connection.Line, Spell = SettingWording.AtCommandLine };
        await JobPageFile.WriteAsync(context, request.WithRunOf(context.History.Look()), path, cancellation).ConfigureAwait(false);
    }
}

/// <summary>Writes the report page of a job, for REPORT and HISTORY.</summary>
internal static class JobPageFile
{
    public static async Task WriteAsync(CommandContext context, JobReportRequest request, string path, CancellationToken cancellation)
    {
        var report = await Task.Run(() => JobReport.Create(request, cancellation), cancellation).ConfigureAwait(false);
        OutputFile.Write(path, output => JobReportPage.Write(report, context.Time.LocalTimeZone, output));
        if (report.Run is { } run && context.History.Keep(run with { Report = Path.GetFullPath(path) }) is { } failure) context.Say(Wording.Get("History.NotKept", failure), MessageKind.Warning);
        context.Say(Wording.Get("Report.Written", path), MessageKind.Result);
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
