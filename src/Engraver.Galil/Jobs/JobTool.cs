using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs;

namespace Engraver.Galil.Jobs;

/// <summary>The tool of a job: switched by an output, with a settle time by the controller's clock, or moved by the Z axis. A dry run never switches it on;
/// a tool that an axis moves is then raised (<see cref="DryRunLift"/>).</summary>
internal sealed class JobTool(JobMachine machine, bool dryRun)
{
    /// <summary>Samples per second on hardware at TM 1000 (galil-dmc.md C, TIME); the larger of the two readings, so that a settle time is never too
    /// short.</summary>
    private const double SamplesPerSecond = 1024.0;

    private bool _isOn;
    private bool _isHeldOff;

    /// <summary>An axis that drives the tool was at clearance height: a lower height before, where the operator had touched the work, was not a
    /// cut.</summary>
    private bool _wasUp;

    /// <summary>How the tool is brought to the work and taken away at the present stroke; null: as the profile states.</summary>
    public StrokeTerms? Terms { get; set; }

    /// <summary>The outputs of operations as this job has set them last; null where they are not known.</summary>
    private int? _outputs;

    /// <summary>Volts of the analog output as this job has set them last; null before, and without one.</summary>
    private double? _volts;

    private StrokeTerms? PresentTerms => machine.Phase.Program is { } program ? program.TermsAt(machine.State.Calls) : Terms;

    /// <summary>State of the output that this poll should show: as this job switched it, or as the program in the controller should have switched it. In a
    /// dry run and while the job is held always off. Null where it is not known, or no output is the tool.</summary>
    public bool? Wanted(JobPoll state) =>
        machine.Profile.Height is not null ? null : dryRun || _isHeldOff ? false : machine.Phase.Program is null ? _isOn : ChunkProgress.IsToolWanted(state);

    /// <summary>Brings the tool to the work, and waits as the operation of the stroke states; a hold ends this wait.</summary>
    /// <param name="at">Where the cut begins, job frame; only its height is used, and only where an axis drives the tool.</param>
    public ValueTask OnAsync(CountsPoint at) => machine.Profile.Height is not null ? PlungeAsync(at.Z + machine.Frame.Origin.Z) : dryRun || _isOn ? ValueTask.CompletedTask : SwitchAsync(true);

    /// <summary>Waits at the end of a stroke as its operation states.</summary>
    public ValueTask DwellAsync() => Terms is { DwellSeconds: > 0.0 and var seconds } ? WaitAsync(seconds) : ValueTask.CompletedTask;

    /// <summary>Takes the tool from the work.</summary>
    public ValueTask OffAsync() => machine.Profile.Height is not null ? ClearAsync() : _isOn ? SwitchAsync(false) : ValueTask.CompletedTask;

    /// <summary>Before a rapid: where an axis drives the tool it must be at clearance height, or above.</summary>
    public async ValueTask ClearAsync()
    {
        if (machine.Profile.Height is null) return;
        await machine.PollAsync().ConfigureAwait(false);
        var clearance = machine.Frame.Origin.Z + machine.Profile.ClearanceCounts;
        if (machine.Profile.IsLower(machine.State.Position.Z, clearance)) await RapidMove.ToHeightAsync(machine, clearance).ConfigureAwait(false);
        _wasUp = true;
    }

    /// <summary>Whether the tool was at work at the last poll: its output on, whichever host or program switched it, or its height below the retract
    /// height once the job had raised it.</summary>
    public bool IsSeenOn(JobPoll? known) =>
        !dryRun && known is { } state && (machine.Profile.Height is null ? IsOutputOn(state) : _wasUp && machine.Profile.IsLower(state.Position.Z, machine.Frame.Origin.Z + machine.Profile.RetractCounts));

    /// <summary>The same of an output, in a dry run too; never for a tool that an axis drives.</summary>
    public bool IsOutputOn(JobPoll state) => machine.Profile.Height is null && machine.Profile.Tool.IsOn(state.Outputs);

    /// <summary>The job has a spindle that turns.</summary>
    public bool HasSpindle => !dryRun && machine.Profile.Spindle is not null;

    /// <summary>Switches the spindle, and waits until it has its speed; off with the outputs of operations. A dry run leaves it off. Where programs in the
    /// controller run the job it is switched on only by <see cref="TurnForProgramAsync"/>.</summary>
    public ValueTask TurnAsync(bool on) => on && machine.Phase.TurnsForPrograms ? ValueTask.CompletedTask : SwitchSpindleAsync(on);

    /// <summary>In a hold the spindle alone stops: outputs of operations stay as they are.</summary>
    public ValueTask StopInHoldAsync() => SwitchSpindleAsync(on: false, isHeld: true);

    /// <summary>Spindle on for a program that is loaded and watched; waits until it has its speed.</summary>
    public ValueTask TurnForProgramAsync() => SwitchSpindleAsync(on: true);

    private async ValueTask SwitchSpindleAsync(bool on, bool isHeld = false)
    {
        if (dryRun) return;
        if (!on)
        {
            await machine.Commands.SendAllAsync(isHeld ? Subprograms.SpindleOffCommands(machine.Profile) : Subprograms.RestOffCommands(machine.Profile)).ConfigureAwait(false);
            if (!isHeld) _outputs = null;
            _volts = null;
        }
        else if (machine.Profile.Spindle is { } spindle)
        {
            var terms = PresentTerms;
            await machine.Commands.SendAllAsync(Subprograms.SpindleOn(spindle, terms)).ConfigureAwait(false);
            _volts = spindle.SpeedAxis is null ? null : terms?.Volts ?? spindle.SpeedVolts;
            await WaitAsync(spindle.SpinUpSeconds).ConfigureAwait(false);
        }
    }

    /// <summary>Before the machine moves to a stroke: sets the outputs that its operation states, and waits until the spindle has its speed. A dry run leaves
    /// them off.</summary>
    public async ValueTask PrepareAsync(StrokeTerms? terms)
    {
        Terms = terms;
        if (dryRun || terms is not { SetsOutputs: true } || (_outputs == terms.OutputsOn && _volts == terms.Volts)) return;
        await machine.Commands.SendAllAsync(Subprograms.Outputs(machine.Profile, terms)).ConfigureAwait(false);
        if (terms.ReadySeconds > 0.0 && _volts is { } before && before != terms.Volts) await WaitAsync(terms.ReadySeconds).ConfigureAwait(false);
        (_outputs, _volts) = (terms.OutputsOn, terms.Volts);
    }

    /// <summary>At rapid speed down to the retract height, then at the plunge feed; straight up where the tool is lower.</summary>
    private async ValueTask PlungeAsync(int goal)
    {
        var (from, retract) = (machine.State.Position.Z, machine.Frame.Origin.Z + machine.Profile.RetractCounts);
        if (from == goal) return;
        if (machine.Profile.IsLower(retract, from)) await RapidMove.ToHeightAsync(machine, machine.Profile.IsLower(retract, goal) ? goal : retract).ConfigureAwait(false);
        await RapidMove.ToHeightAsync(machine, goal, _ => machine.Profile.PlungeSpeed(Terms)).ConfigureAwait(false);
        await PierceAsync(Terms).ConfigureAwait(false);
    }

    /// <summary>Off for the time of a hold, whether this job or a program switched it on; nothing where it is off, or where an axis drives the
    /// tool.</summary>
    public async ValueTask HoldOffAsync()
    {
        if (dryRun || machine.Profile.Height is not null || !(machine.Phase.Program is null ? _isOn : IsOutputOn(machine.State))) return;
        await SendAsync(on: false).ConfigureAwait(false);
        _isHeldOff = true;
    }

    /// <summary>After a hold: on again with its settle time where the cut continues; otherwise it stays off.</summary>
    public async ValueTask HoldOnAsync(bool isCutting)
    {
        if (!_isHeldOff) return;
        if (isCutting) await SendAsync(on: true).ConfigureAwait(false);
        _isHeldOff = false;
        if (!isCutting)
        {
            _isOn = false;
            return;
        }

        await WaitAsync(machine.Profile.ToolSettleSeconds).ConfigureAwait(false);
        await PierceAsync(PresentTerms).ConfigureAwait(false);
    }

    /// <summary>What was in progress is given up with the tool off: no hold switches it on again.</summary>
    public void GiveUp() => (_isHeldOff, _isOn) = (false, false);

    private async ValueTask SwitchAsync(bool on)
    {
        await SendAsync(on).ConfigureAwait(false);
        _isOn = on;
        await WaitAsync(on ? machine.Profile.ToolSettleSeconds : machine.Profile.OffSettleSeconds).ConfigureAwait(false);
        if (on) await PierceAsync(Terms).ConfigureAwait(false);
    }

    private ValueTask PierceAsync(StrokeTerms? terms) => terms is { PierceSeconds: > 0.0 and var seconds } ? WaitAsync(seconds, endsWithHold: true) : ValueTask.CompletedTask;

    private ValueTask SendAsync(bool on) => machine.Commands.SendAsync(Subprograms.Switch(machine.Profile.ToolOutput, on != machine.Profile.ToolActiveLow, " "));

    private async ValueTask WaitAsync(double seconds, bool endsWithHold = false)
    {
        await machine.GlanceAsync().ConfigureAwait(false);
        var from = machine.State.Time;
        var samples = Math.Ceiling(seconds * SamplesPerSecond);
        await machine.GlanceUntilAsync(state => PollTimes.SamplesSince(from, state.Time) >= samples || (endsWithHold && machine.Hold.IsHoldWanted), seconds).ConfigureAwait(false);
    }
}
