using Engraver.Galil.Jobs.Watching;

namespace Engraver.Galil.Jobs;

/// <summary>The tool of a job: switched by commands, with a settle time by the controller's clock. A dry run never switches it on.</summary>
internal sealed class JobTool(JobMachine machine, bool dryRun)
{
    /// <summary>Samples per second on hardware at TM 1000 (galil-dmc.md C, TIME); the larger of the two readings, so that a settle time is never too short.</summary>
    private const double SamplesPerSecond = 1024.0;

    private bool _isOn;

    /// <summary>State of the output that a poll should show, where a program in the controller switches it; null where this job does.</summary>
    public Func<MachineState, bool?>? WantedByProgram { get; set; }

    /// <summary>State of the output that this poll should show: as this job switched it, or as the program should have; null where it is not known. In a dry run always off.</summary>
    public bool? Wanted(MachineState state) => dryRun ? false : WantedByProgram is { } program ? program(state) : _isOn;

    public ValueTask<JobStep> OnAsync() => dryRun || _isOn ? new(JobStep.Done) : SwitchAsync(true);

    public ValueTask<JobStep> OffAsync() => _isOn ? SwitchAsync(false) : new(JobStep.Done);

    /// <summary>Whether the output was on at the last poll, whoever switched it.</summary>
    public bool IsSeenOn(MachineState? known) => !dryRun && known is { } state && IsOutputOn(state);

    /// <summary>The same, in a dry run too.</summary>
    public bool IsOutputOn(MachineState state) => (state.Outputs & (1 << (machine.Profile.ToolOutput - 1))) != 0;

    private async ValueTask<JobStep> SwitchAsync(bool on)
    {
        if (await machine.SendAsync(JobMachine.Text($"{(on ? "SB" : "CB")} {machine.Profile.ToolOutput}")).ConfigureAwait(false) is { Ends: true } refused) return refused;
        _isOn = on;
        if (await machine.GlanceAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        var from = machine.State.Time;
        var samples = Math.Ceiling(machine.Profile.ToolSettleSeconds * SamplesPerSecond);
        return await machine.GlanceUntilAsync(state => PollTimes.SamplesSince(from, state.Time) >= samples, machine.Profile.ToolSettleSeconds).ConfigureAwait(false);
    }
}
