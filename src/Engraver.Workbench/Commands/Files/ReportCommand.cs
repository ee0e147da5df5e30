using Engraver.Workbench.CommandLanguage;
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
        var name = await context.ValueAsync(new FilePrompt(Wording.Get("Report.EnterFileName"), new FileRequest("report", true, ".html") { Suggested = Path.GetFullPath(JobReportPage.PathOf(drawing.FileName)) }) { Default = usual }).ConfigureAwait(false);
        var path = name == usual ? JobReportPage.PathOf(drawing.FileName) : context.ResolveOutputPath(name);
        if (name != usual || !context.IsScripted) await ReplacePrompt.ConfirmAsync(context, path, name).ConfigureAwait(false);
        var request = new JobReportRequest(drawing, settings, context.Derivation.Strategy, context.Time.GetUtcNow()) { Families = context.Families, Address = context.Machine.Connection.Line, Spell = SettingWording.AtCommandLine, Plate = context.Plates.Of(context.Document.Current) };
        await JobReportFile.WriteAsync(context, request.WithRunOf(context.History.Refresh()), path, cancellation).ConfigureAwait(false);
    }
}
