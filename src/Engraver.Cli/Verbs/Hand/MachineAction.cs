using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Machines;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs.Hand;

/// <summary>One action on a machine: connects, acts, and prints the status that follows.</summary>
internal sealed class MachineAction(VerbHost host)
{
    private readonly Option<ControllerAddress?> _connect = ConnectOption.New(required: true, Wording.Get("Hand.Connect"));
    private readonly Option<bool> _json = JsonOption.New();
    private readonly Option<string?> _profile = new("--machine") { HelpName = "PROFILE.json", Description = Wording.Get("Hand.Machine") };

    /// <summary>A verb with the options of every action.</summary>
    public MachineCommand Command(string name, string description) => new(name, description) { _connect, _json, _profile };

    /// <param name="homes">The action homes the machine; a simulated one then starts away from its switches.</param>
    public async Task<int> RunAsync(ParseResult parsed, Func<MachineSession, CancellationToken, Task<int>> action, CancellationToken stop, bool homes = false)
    {
        var address = parsed.GetRequiredValue(_connect)!;
        await using var machine = new MachineSession(TimeProvider.System, MachineMemories.FolderIn(null), simulatedIsHomed: !homes);
        if (parsed.GetValue(_profile) is { } profile) machine.Profile = ProfileOption.Load(parsed, profile);
        await machine.Connection.ConnectAsync(address, stop).ConfigureAwait(false);
        var code = await action(machine, stop).ConfigureAwait(false);
        var status = StatusJson.From(machine.Status, machine.Connection.Lease?.Memory, machine.Profile);
        if (parsed.GetValue(_json)) ContractJson.Write(host.Out, status, ContractJson.Default.StatusJson);
        else foreach (var line in status.Text()) await host.Out.WriteLineAsync(line.AsMemory(), stop).ConfigureAwait(false);
        return code;
    }

    /// <summary>Reports why a move is not complete.</summary>
    public int Conclude(JobResult result)
    {
        if (result is { Outcome: JobOutcome.Refused, Diagnostics: [{ } refusal, ..], FinalPosition: null }) return NotMoved(SettingWording.OnConsole(refusal).Message);
        if (result.Outcome != JobOutcome.Complete) host.Error.WriteLine($"engraver: {result.Message}");
        foreach (var left in result.NotRestored) host.Error.WriteLine(Wording.Get("Run.NotRestored", left));
        return ExitCode.Of(result.Outcome);
    }

    public int NotMoved(string why)
    {
        host.Error.WriteLine(Wording.Get("Hand.NotMoved", why));
        return ExitCode.DrawingError;
    }
}
