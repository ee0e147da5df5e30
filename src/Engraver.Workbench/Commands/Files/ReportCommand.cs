using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports.Pages;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Files;

/// <summary>REPORT: Writes the job of the drawing, with its last run, as a page for the browser and for paper.</summary>
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
        var request = new JobReportRequest(drawing, settings, context.Derivation.Mode, context.Time.GetUtcNow()) { Address = context.Machine.Connection.Line, Spell = SettingWording.AtCommandLine };
        await JobPageFile.WriteAsync(context, request.WithRunOf(context.History.Look()), path, cancellation).ConfigureAwait(false);
    }
}

/// <summary>Writes the page of a job, for REPORT and HISTORY.</summary>
internal static class JobPageFile
{
    public static async Task WriteAsync(CommandContext context, JobReportRequest request, string path, CancellationToken cancellation)
    {
        var report = await Task.Run(() => JobReport.Create(request, cancellation), cancellation).ConfigureAwait(false);
        OutputFile.Write(path, output => JobReportPage.Write(report, context.Time.LocalTimeZone, output));
        if (report.Run is { } run && context.History.Keep(run with { Report = Path.GetFullPath(path) }) is { } failure) context.Say(Wording.Get("History.NotKept", failure), MessageKind.Warning);
        context.Say(Wording.Get("Report.Written", path), MessageKind.Result);
    }

    /// <summary>The page of a job in the history: its drawing as it is now, with the settings of then.</summary>
    /// <exception cref="CommandException">The drawing cannot be read any more.</exception>
    public static Task WriteAsync(CommandContext context, HistoryEntry entry, DrawingSettings settings, CancellationToken cancellation)
    {
        var drawing = DrawingFile.Open(entry.Drawing, settings, cancellation);
        if (DrawingFile.IsUnreadable(drawing)) throw new CommandException(CommandFailure.Drawing, Wording.Get("Report.DrawingUnreadable", entry.Drawing, drawing.Diagnostics[0].Message));
        var mode = entry.Mode switch { "calls" => JobMode.Calls, "program" => JobMode.Program, _ => JobMode.Stream };
        var address = entry.Address is { } word && ControllerAddress.TryParse(word, out var known) ? known : null;
        var request = new JobReportRequest(drawing, settings, mode, context.Time.GetUtcNow()) { Address = address, Run = entry, Journal = entry.Journal, Spell = SettingWording.AtCommandLine };
        return WriteAsync(context, request, JobReportPage.PathOf(entry.Drawing), cancellation);
    }
}
