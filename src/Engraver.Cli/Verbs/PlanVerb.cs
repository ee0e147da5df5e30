using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Galil.Programs;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver plan</c>: how long the streamed job will take on the machine, and what it asks of it.</summary>
internal static class PlanVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var json = JsonOption.New();
        var command = new Command("plan", "Says how long the job takes on the machine, without a machine.");
        drawing.AddTo(command);
        command.Options.Add(json);
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            var job = JobPreparation.Prepare(read, settings, MotionStyle.Continuous);
            var plan = PlanReport.Json(job);
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, plan, ContractJson.Default.PlanJson);
            else PlanReport.Text(host.Out, plan);
            return Task.FromResult(host.Report(parsed, read.FileName, job.Diagnostics));
        });
        return command;
    }
}
