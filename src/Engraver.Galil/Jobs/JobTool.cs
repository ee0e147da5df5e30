using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs;

namespace Engraver.Galil.Jobs;

/// <summary>The tool of a job: switched by an output, with a settle time by the controller's clock, or moved by the Z axis. A dry run never switches it on;
/// a tool that is moved then runs in the air (<see cref="DryLift"/>).</summary>
internal sealed class JobTool(JobMachine machine, bool dryRun)
{
    /// <summary>Samples per second on hardware at TM 1000 (galil-dmc.md C, TIME); the larger of the two readings, so that a settle time is never too
    /// short.</summary>
    private const double SamplesPerSecond = 1024.0;

    private bool _isOn;
    private bool _isHeldOff;

    /// <summary>An axis that holds the tool was at clearance height: what was lower before, where the operator had touched the work, was no cut.</summary>
    private bool _wasUp;

    /// <summary>State of the output that a poll should show, where a program in the controller switches it; null where this job does.</summary>
    public Func<MachineState, bool?>? WantedByProgram { get; set; }

    /// <summary>State of the output that this poll should show: as this job switched it, or as the program should have; null where it is not known, or no
    /// output is the tool. In a dry run and while the job is held always off.</summary>
    public bool? Wanted(MachineState state) => machine.Profile.Height is not null ? null : dryRun || _isHeldOff ? false : WantedByProgram is { } program ? program(state) : _isOn;

    /// <summary>Brings the tool to the work.</summary>
    /// <param name="at">Where the cut begins, job frame; only its height matters, and only where an axis holds the tool.</param>
    public ValueTask<JobStep> OnAsync(CountsPoint at) => machine.Profile.Height is not null ? PlungeAsync(at.Z + machine.Frame.Z) : dryRun || _isOn ? new(JobStep.Done) : SwitchAsync(true);

    /// <summary>Takes the tool from the work.</summary>
    public ValueTask<JobStep> OffAsync() => machine.Profile.Height is not null ? ClearAsync() : _isOn ? SwitchAsync(false) : new(JobStep.Done);

    /// <summary>Before a rapid: where an axis holds the tool it must be at clearance height, or above.</summary>
    public async ValueTask<JobStep> ClearAsync()
    {
        if (machine.Profile.Height is null) return JobStep.Done;
        if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        var clearance = machine.Frame.Z + machine.Profile.ClearanceCounts;
        if (machine.Profile.IsLower(machine.State.Position.Z, clearance) && await RapidMove.ToHeightAsync(machine, clearance).ConfigureAwait(false) is { Ends: true } low) return low;
        _wasUp = true;
        return JobStep.Done;
    }

    /// <summary>Whether the tool was at work at the last poll: its output on, whoever switched it, or its height below the retract height once the job had
    /// raised it.</summary>
    public bool IsSeenOn(MachineState? known) => !dryRun && known is { } state && (machine.Profile.Height is null ? IsOutputOn(state) : _wasUp && machine.Profile.IsLower(state.Position.Z, machine.Frame.Z + machine.Profile.RetractCounts));

    /// <summary>The same of an output, in a dry run too; never for a tool that an axis holds.</summary>
    public bool IsOutputOn(MachineState state) => machine.Profile.Height is null && machine.Profile.Tool.IsOn(state.Outputs);

    /// <summary>This job has a spindle that turns.</summary>
    public bool HasSpindle => !dryRun && machine.Profile.Spindle is not null;

    /// <summary>A program in the controller runs the job, and the spindle is switched on by <see cref="TurnForProgramAsync"/> only.</summary>
    public bool TurnsForProgram { private get; set; }

    /// <summary>Switches the spindle, and waits until it turns. A dry run leaves it off.</summary>
    public ValueTask<JobStep> TurnAsync(bool on) => on && TurnsForProgram ? new(JobStep.Done) : SwitchSpindleAsync(on);

    /// <summary>Spindle on for a program that is loaded and watched, and waits until it turns.</summary>
    public ValueTask<JobStep> TurnForProgramAsync() => SwitchSpindleAsync(on: true);

    private async ValueTask<JobStep> SwitchSpindleAsync(bool on)
    {
        if (dryRun || machine.Profile.Spindle is not { } spindle) return JobStep.Done;
        if (await machine.SendAllAsync(on ? Subprograms.SpindleOn(spindle) : Subprograms.SpindleOff(spindle)).ConfigureAwait(false) is { Ends: true } refused) return refused;
        return on ? await WaitAsync(spindle.SpinUpSeconds).ConfigureAwait(false) : JobStep.Done;
    }

    /// <summary>Fast down to the retract height, then at the plunge feed; straight up where it stands deeper.</summary>
    private async ValueTask<JobStep> PlungeAsync(int goal)
    {
        var (from, retract) = (machine.State.Position.Z, machine.Frame.Z + machine.Profile.RetractCounts);
        if (from == goal) return JobStep.Done;
        if (machine.Profile.IsLower(retract, from))
        {
            var fast = machine.Profile.IsLower(retract, goal) ? goal : retract;
            if (await RapidMove.ToHeightAsync(machine, fast).ConfigureAwait(false) is { Ends: true } end) return end;
        }

        return await RapidMove.ToHeightAsync(machine, goal, _ => machine.Profile.PlungeSpeed()).ConfigureAwait(false);
    }

    /// <summary>Off for the time of a hold, whoever switched it on; nothing where it is off, or where an axis holds the tool.</summary>
    public async ValueTask<JobStep> HoldOffAsync()
    {
        if (dryRun || machine.Profile.Height is not null || !(WantedByProgram is null ? _isOn : IsOutputOn(machine.State))) return JobStep.Done;
        if (await SendAsync(on: false).ConfigureAwait(false) is { Ends: true } refused) return refused;
        _isHeldOff = true;
        return JobStep.Done;
    }

    /// <summary>Behind a hold: on again with its settle time where the cut goes on; else it is off as if nobody had switched it on.</summary>
    public async ValueTask<JobStep> HoldOnAsync(bool isCutting)
    {
        if (!_isHeldOff) return JobStep.Done;
        if (isCutting && await SendAsync(on: true).ConfigureAwait(false) is { Ends: true } refused) return refused;
        _isHeldOff = false;
        if (!isCutting) _isOn = false;
        return isCutting ? await WaitAsync(machine.Profile.ToolSettleSeconds).ConfigureAwait(false) : JobStep.Done;
    }

    /// <summary>What was under way is given up: the tool is off, and a program that may have switched it no longer runs.</summary>
    public void Part() => (_isHeldOff, _isOn, WantedByProgram) = (false, false, null);

    private async ValueTask<JobStep> SwitchAsync(bool on)
    {
        if (await SendAsync(on).ConfigureAwait(false) is { Ends: true } refused) return refused;
        _isOn = on;
        return await WaitAsync(on ? machine.Profile.ToolSettleSeconds : machine.Profile.OffSettleSeconds).ConfigureAwait(false);
    }

    private ValueTask<JobStep> SendAsync(bool on) => machine.SendAsync(Subprograms.Switch(machine.Profile.ToolOutput, on != machine.Profile.ToolActiveLow, " "));

    private async ValueTask<JobStep> WaitAsync(double seconds)
    {
        if (await machine.GlanceAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        var from = machine.State.Time;
        var samples = Math.Ceiling(seconds * SamplesPerSecond);
        return await machine.GlanceUntilAsync(state => PollTimes.SamplesSince(from, state.Time) >= samples, seconds).ConfigureAwait(false);
    }
}
