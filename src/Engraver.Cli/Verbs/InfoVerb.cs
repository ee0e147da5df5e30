using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Drawings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver info</c>: what is in a drawing, with a balance sheet that accounts for every record.</summary>
internal static class InfoVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var json = JsonOption.New();
        var command = new Command("info", "Says what is in a drawing and what was not read.");
        drawing.AddTo(command);
        command.Options.Add(json);
        command.SetAction((parsed, stop) =>
        {
            var read = DrawingFile.Open(drawing.File(parsed), drawing.Settings(parsed).Unit, stop);
            var summary = DrawingSummary.Of(read);
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, InfoReport.Json(read, summary), ContractJson.Default.InfoJson);
            else DrawingText.Write(host.Out, read, summary);
            return Task.FromResult(host.Report(parsed, read.FileName, read.Diagnostics));
        });
        return command;
    }
}
