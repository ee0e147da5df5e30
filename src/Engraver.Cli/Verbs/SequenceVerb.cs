using System.CommandLine;
using System.Diagnostics;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Stages;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver sequence</c>: contours, their order and their gaps.</summary>
internal static class SequenceVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var json = JsonOption.New();
        var output = new Option<string?>("-o", "--output") { HelpName = "CLDATA.dxf", Description = Wording.Get("Sequence.Output") };
        var command = new Command("sequence", Wording.Get("Sequence.Summary"));
        drawing.AddTo(command);
        command.Options.Add(json);
        command.Options.Add(output);
        command.SetAction((parsed, stop) =>
        {
            OutputFormat.Check(parsed.GetValue(output), ".dxf");
            var settings = drawing.Settings(parsed);
            var (read, readSeconds) = Timed(() => DrawingFile.Open(drawing.File(parsed), settings, stop));
            var run = new StageRun(new DrawnJob(read, settings), stop);
            var (_, chainSeconds) = Timed(run.To<ChainedJob>);
            var (ordered, orderSeconds) = Timed(run.To<OrderedJob>);
            var result = ordered.Sequence;
            var posted = parsed.GetValue(output) is null ? null : PostedProgram.FromSequence(ordered, PostTable.ForExtension(".dxf")!.Post, PostedProgram.NoOptions);
            if (posted?.Text is { } text) host.Write(parsed.GetValue(output), writer => writer.Write(text));
            var seconds = new SequenceJson.SecondsJson(readSeconds, chainSeconds, orderSeconds);
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, SequenceReport.Json(result, ordered.Passes, seconds), ContractJson.Default.SequenceJson);
            else SequenceText.Write(host.Out, result);
            return Task.FromResult(host.Report(parsed, read.FileName, [.. posted?.Diagnostics ?? [.. ordered.Drawing.Diagnostics, .. JobPreparation.Findings(ordered), .. result.Diagnostics], .. ordered.OperationFaults, .. ordered.Cut.FindingsBeside(result)]));
        });
        return command;
    }

    private static (T Result, double Seconds) Timed<T>(Func<T> stage)
    {
        var start = Stopwatch.GetTimestamp();
        var result = stage();
        return (result, Stopwatch.GetElapsedTime(start).TotalSeconds);
    }
}
