using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver frame</c>: moves once around the placed job with the tool off.</summary>
internal sealed class FrameVerb
{
    private readonly VerbHost _host;
    private readonly DrawingOptions _drawing = new();
    private readonly Option<ControllerAddress?> _connect = ConnectOption.New(required: true, Wording.Get("Hand.Connect"));
    private readonly Option<bool> _json = JsonOption.New();
    private readonly Option<bool> _hull = new("--hull") { Description = Wording.Get("Frame.Hull") };

    private FrameVerb(VerbHost host) => _host = host;

    public static Command Build(VerbHost host)
    {
        var verb = new FrameVerb(host);
        var command = new MachineCommand("frame", Wording.Get("Frame.Summary"));
        verb._drawing.AddTo(command);
        foreach (var option in (Option[])[verb._connect, verb._json, verb._hull]) command.Options.Add(option);
        command.SetAction(verb.RunAsync);
        return command;
    }

    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        var settings = _drawing.Settings(parsed);
        var file = _drawing.File(parsed);
        var shape = parsed.GetValue(_hull) ? FrameShape.Hull : FrameShape.Rectangle;
        var (job, frame) = await StoppableVerb.ComputeAsync(
            () =>
            {
                var prepared = JobPreparation.Prepare(DrawingFile.Open(file, settings, stop), settings, MachineFamilies.DriverOf(settings.Machine).DefaultStrategy.Style);
                return (prepared, JobFrame.Of(prepared, shape));
            },
            stop).ConfigureAwait(false);
        _host.Report(parsed, job.Drawing.FileName, job.Diagnostics);
        if (frame is null) return _host.NotMoved($"{job.NoProgramReason}.");
        await using var machine = new MachineSession(TimeProvider.System, MachineMemories.FolderIn(null), simulatedIsHomed: true) { Profile = settings.Machine };
        await machine.Connection.ConnectAsync(parsed.GetRequiredValue(_connect)!, stop).ConfigureAwait(false);
        var placement = await machine.Origins.AskAsync(frame, dryRun: true, stop).ConfigureAwait(false);
        var list = ArmingChecklist.ForFrameOnConsole(job, machine.Profile, machine.Status, placement);
        if (!parsed.GetValue(_json)) _host.Print(parsed, list);
        var code = list.FailureText is { } unready ? _host.NotMoved(unready) : ReportResult(await machine.Runs.FrameAsync(frame, JournalFolder.NewJournal("frame", TimeProvider.System), stop).ConfigureAwait(false));
        var status = StatusJson.From(machine.Status, machine.Connection.Lease?.Memory, machine.Profile) with { Checks = StartCheckJson.Of(list) };
        if (parsed.GetValue(_json)) ContractJson.Write(_host.Out, status, ContractJson.Default.StatusJson);
        else foreach (var line in status.Text()) await _host.Out.WriteLineAsync(line.AsMemory(), stop).ConfigureAwait(false);
        return code;
    }

    private int ReportResult(JobResult result)
    {
        if (result.FrameOrigin is null && result.Diagnostics is [var unplaced, ..]) return _host.NotMoved(SettingWording.OnConsole(unplaced).Message);
        if (result.Outcome != JobOutcome.Complete) _host.Error.WriteLine($"engraver: {result.Message}");
        return ExitCode.Of(result.Outcome);
    }
}
