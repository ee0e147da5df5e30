using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver post</c>: a self-contained DMC program, or the sequenced drawing.</summary>
internal static class PostVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var target = new Option<string>("--target") { Required = true, Description = Wording.Get("Post.GalilContinuousVectorSequences") };
        target.AcceptOnlyFromAmong([.. PostedProgram.Targets]);
        var output = new Option<string?>("-o", "--output") { HelpName = "OUT", Description = Wording.Get("Verbs.FileWriteDefaultStandard") };
        var command = new Command("post", Wording.Get("Post.WritesJobProgramController"));
        drawing.AddTo(command);
        command.Options.Add(target);
        command.Options.Add(output);
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            var posted = PostedProgram.Create(read, settings, parsed.GetRequiredValue(target));
            if (posted.Text is { } text) host.Write(parsed.GetValue(output), writer => writer.Write(text));
            return Task.FromResult(host.Report(parsed, read.FileName, posted.Diagnostics));
        });
        return command;
    }
}
