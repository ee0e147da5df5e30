using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Stages;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver info</c>: the contents of a drawing, with a balance that accounts for every record.</summary>
internal static class InfoVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var json = JsonOption.New();
        var twice = new Option<bool>("--twice") { Description = Wording.Get("Info.Twice") };
        var command = new Command("info", Wording.Get("Info.Summary"));
        drawing.AddTo(command);
        command.Options.Add(json);
        command.Options.Add(twice);
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            StageOptions.CheckLayers(read, settings);
            var summary = DrawingSummary.From(read);
            IReadOnlyList<Diagnostic> found = [.. read.Diagnostics, .. JobPreparation.Findings(JobPreparation.To<LetteredJob>(read, settings))];
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, InfoReport.Json(read, summary, found), ContractJson.Default.InfoJson);
            else DrawingText.Write(host.Out, read, summary);
            // The second reader handles curves only, not the outlines of --cut, and does not place them.
            var curves = settings is { Cut: CutChoice.None, Placement.IsNone: true } ? summary : DrawingSummary.From(DrawingFile.Open(read.FileName, settings with { Cut = CutChoice.None, Placement = DrawingPlacement.None }, stop));
            var agrees = !parsed.GetValue(twice) || CrossCheckReport.Write(host.Error, read, curves);
            var code = host.Report(parsed, read.FileName, found);
            return Task.FromResult(agrees ? code : ExitCode.DrawingError);
        });
        return command;
    }
}
