using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Drawings;
using Engraver.Galil.Programs;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver post</c>: a self-contained DMC program, or CL data.</summary>
internal static class PostVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var target = new Option<string>("--target") { Required = true, Description = "galil: continuous vector sequences; galil-calls: the paper's calls of #LINEAR and #CIRC; cldata: the sequenced drawing as DXF." };
        target.AcceptOnlyFromAmong("galil", "galil-calls", "cldata");
        var output = new Option<string?>("-o", "--output") { HelpName = "OUT", Description = "File to write (default: standard output)." };
        var command = new Command("post", "Writes the job as a program for the controller.");
        drawing.AddTo(command);
        command.Options.Add(target);
        command.Options.Add(output);
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var read = DrawingFile.Open(drawing.File(parsed), settings.Unit, stop);
            if (parsed.GetValue(target) == "cldata") return Task.FromResult(WriteClData(host, parsed, read, settings, parsed.GetValue(output)));
            var calls = parsed.GetValue(target) == "galil-calls";
            var job = JobPreparation.Prepare(read, settings, calls ? MotionStyle.Calls : MotionStyle.Continuous);
            var diagnostics = job.Diagnostics.ToList();
            if (job.Motion.Program is { } program)
            {
                var post = calls ? DmcPost.Calls(program, DmcPostOptions.Default, read.SourceOf) : DmcPost.Sequences(program, DmcPostOptions.Default, read.SourceOf);
                diagnostics.AddRange(post.Diagnostics);
                host.Write(parsed.GetValue(output), writer => writer.Write(post.Text));
            }

            return Task.FromResult(host.Report(parsed, read.FileName, diagnostics));
        });
        return command;
    }

    private static int WriteClData(VerbHost host, ParseResult parsed, Drawing read, DrawingSettings settings, string? output)
    {
        var sequence = JobPreparation.Sequence(read, JobPreparation.Analyse(read, settings), settings);
        ClDataOutput.Write(host, output, read, sequence, settings);
        return host.Report(parsed, read.FileName, [.. read.Diagnostics, .. sequence.Diagnostics]);
    }
}
