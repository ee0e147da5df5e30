using System.CommandLine;
using System.Diagnostics;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver sequence</c>: contours, their order, and where they are broken.</summary>
internal static class SequenceVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var json = JsonOption.New();
        var command = new Command("sequence", "Chains the drawing into contours, orders them, and names every discontinuity.");
        drawing.AddTo(command);
        command.Options.Add(json);
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var start = Stopwatch.GetTimestamp();
            var read = DrawingFile.Open(drawing.File(parsed), settings.Unit, stop);
            var readSeconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
            var result = JobPreparation.Sequence(read, JobPreparation.Analyse(read, settings), settings);
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, SequenceReport.Json(read, result, readSeconds), ContractJson.Default.SequenceJson);
            else SequenceReport.Text(host.Out, result);
            return Task.FromResult(host.Report(parsed, read.FileName, [.. read.Diagnostics, .. result.Diagnostics]));
        });
        return command;
    }
}
