using System.CommandLine;
using System.Diagnostics;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Sequencing;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver sequence</c>: contours, their order, and where they are broken.</summary>
internal static class SequenceVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var json = JsonOption.New();
        var output = new Option<string?>("-o", "--output") { HelpName = "CLDATA.dxf", Description = Wording.Get("Sequence.AlsoWriteSequencedOriented") };
        var command = new Command("sequence", Wording.Get("Sequence.ChainsDrawingIntoContours"));
        drawing.AddTo(command);
        command.Options.Add(json);
        command.Options.Add(output);
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var (read, readSeconds) = Timed(() => DrawingFile.Open(drawing.File(parsed), settings, stop));
            var options = JobPreparation.SequencingFor(read, settings);
            var (chained, chainSeconds) = Timed(() => Sequencer.Chain(JobPreparation.Analyse(read, settings), read, options));
            var (result, orderSeconds) = Timed(() => Sequencer.Order(chained, options));
            var posted = parsed.GetValue(output) is null ? null : PostedProgram.FromSequence(read, chained.Analysed, result, settings, PostTable.ForEnding(".dxf")!.Post, PostedProgram.NoOptions);
            if (posted?.Text is { } text) host.Write(parsed.GetValue(output), writer => writer.Write(text));
            var seconds = new SequenceJson.SecondsJson(readSeconds, chainSeconds, orderSeconds);
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, SequenceReport.Json(result, seconds), ContractJson.Default.SequenceJson);
            else SequenceText.Write(host.Out, result);
            return Task.FromResult(host.Report(parsed, read.FileName, posted?.Diagnostics ?? [.. read.Diagnostics, .. JobPreparation.Findings(read, settings), .. result.Diagnostics]));
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
