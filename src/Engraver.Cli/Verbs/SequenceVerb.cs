using System.CommandLine;
using System.Diagnostics;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Drawings;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

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
            var ((cut, options, chained), chainSeconds) = Timed(() => Chain(read, settings));
            var (result, orderSeconds) = Timed(() => Sequencer.Order(chained, options));
            var posted = parsed.GetValue(output) is null ? null : PostedProgram.FromSequence(read, chained.Analysed, result, settings, PostTable.ForEnding(".dxf")!.Post, PostedProgram.NoOptions);
            if (posted?.Text is { } text) host.Write(parsed.GetValue(output), writer => writer.Write(text));
            var seconds = new SequenceJson.SecondsJson(readSeconds, chainSeconds, orderSeconds);
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, SequenceReport.Json(result, seconds), ContractJson.Default.SequenceJson);
            else SequenceText.Write(host.Out, result);
            return Task.FromResult(host.Report(parsed, read.FileName, [.. posted?.Diagnostics ?? [.. read.Diagnostics, .. JobPreparation.Findings(read, settings), .. result.Diagnostics], .. cut.FindingsBeside(result)]));
        });
        return command;
    }

    /// <summary>Chains the cut entities, as drawn or compensated for the tool radius.</summary>
    private static (CutTable Cut, SequencingOptions Options, ChainedTable Chained) Chain(Drawing drawing, DrawingSettings settings)
    {
        var cut = JobPreparation.ToCut(drawing, settings);
        var options = JobPreparation.SequencingFor(drawing, cut, settings);
        return (cut, options, Sequencer.Chain(cut.Table, drawing, options));
    }

    private static (T Result, double Seconds) Timed<T>(Func<T> stage)
    {
        var start = Stopwatch.GetTimestamp();
        var result = stage();
        return (result, Stopwatch.GetElapsedTime(start).TotalSeconds);
    }
}
