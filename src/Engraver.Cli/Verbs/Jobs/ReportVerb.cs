using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Reports.Pages;

namespace Engraver.Cli.Verbs.Jobs;

/// <summary><c>engraver report</c>: a job, and its run if any, as a page for the browser and for printing.</summary>
internal static class ReportVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var output = new Option<string>("-o", "--output") { Required = true, HelpName = "OUT.html", Description = Wording.Get("Report.Output") };
        var journal = new Option<string?>("--journal") { HelpName = "FILE", Description = Wording.Get("Report.Journal") };
        var connect = ConnectOption.New(required: false, Wording.Get("Plan.Connect"));
        var mode = ModeOption.New();
        var rate = RateOption.New();
        var command = new Command("report", Wording.Get("Report.Summary"));
        drawing.AddTo(command);
        foreach (var option in (Option[])[output, journal, connect, mode, rate]) command.Options.Add(option);
        command.SetAction((parsed, stop) =>
        {
            var (settings, kept) = (drawing.Settings(parsed), parsed.GetValue(journal));
            VerbHost.RejectSameFile(drawing.File(parsed), parsed.GetValue(output));
            OutputFormat.Check(parsed.GetValue(output), ".html", ".htm");
            if (kept is not null && !File.Exists(kept) && !File.Exists(TraceFile.PathOf(kept))) throw new UsageException(Wording.Get("Report.NoJournal", kept));
            var history = new JobHistory(JobHistory.FolderIn(null));
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            var request = new JobReportRequest(read, settings, ModeOption.Strategy(parsed, mode, settings), TimeProvider.System.GetUtcNow()) { Address = parsed.GetValue(connect), Rates = parsed.GetValue(rate), Journal = kept };
            var report = JobReport.Create(request.WithRunOf(history.Refresh()), stop);
            if (!DrawingFile.IsUnreadable(read)) host.Write(parsed.GetValue(output), writer => JobReportPage.Write(report, TimeZoneInfo.Local, writer));
            if (report.Run is { } run && history.Save(run with { Report = Path.GetFullPath(parsed.GetRequiredValue(output)) }) is { } failure) host.Error.WriteLine(Wording.Get("Verbs.HistoryNotWritten", failure));
            if (report.TraceProblem is { } problem) host.Error.WriteLine(Wording.Get("Report.NoTrace", problem));
            return Task.FromResult(host.Report(parsed, read.FileName, report.Job.Diagnostics));
        });
        return command;
    }
}
