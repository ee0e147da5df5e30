using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>One move by hand on a machine that stays connected.</summary>
/// <param name="Name">For the journal.</param>
/// <param name="Doing">For the state, while it lasts.</param>
/// <param name="Journal">Path of the journal to which the state found in the controller is written, so that it can be restored after a crash.</param>
/// <param name="Refuse">Why it may not be made, by where the machine stands; null: it may.</param>
/// <param name="Make">The motion; its options hold the soft limits that are in force.</param>
internal sealed record MachineMove(
    string Name, string Doing, string Journal, Func<MachineMemory, ControllerPlace, Diagnostic?> Refuse, Func<IMachineConnection, MotionProgram, JobOptions, CancellationToken, Task<JobResult>> Make)
{
    /// <summary>The move that is made instead, once it is heard where the machine stands; null: this one. Asked only where <see cref="Refuse"/> does not
    /// refuse.</summary>
    private Func<MachineMemory, ControllerPlace, MachineMove>? Aim { get; init; }

    /// <summary>The machine's own profile, by which it was homed, where the move is made by another one; null where by it.</summary>
    private MachineProfile? Known { get; init; }

    /// <summary>To a place, counts of the controller.</summary>
    /// <param name="withHeight">The height is part of the place; otherwise it stays as it is.</param>
    /// <param name="isStep">The place is told from where the machine stands: then it need not be homed.</param>
    public static MachineMove To(CountsPoint goal, bool withHeight, bool isStep, MachineProfile profile, string journal, IProgress<JobProgress> progress) => new(
        isStep ? "CNCJOG" : "CNCGOTO",
        isStep ? Wording.Get("MachineSession.Jogging") : Wording.Get("MachineSession.Positioning"),
        journal,
        (memory, place) => (isStep ? null : WorkPlacement.NotHomed(memory, place, profile)) switch
        {
            { } unhomed => unhomed,
            _ when memory.KnowsTravel(profile, place) => TravelLimits.Refusal(profile, goal, withHeight),
            _ when isStep => TravelLimits.StepRefusal(profile, goal - place.Position, withHeight),
            _ => memory.Lost.Length > 0 ? PreparationRules.PositionDoubted.At(default, memory.Lost) : null,
        },
        (machine, program, options, stop) => machine.GoToAsync(program, goal, withHeight, options, progress, stop));

    /// <summary>To a place in plan, told by the controller's own zero. A tool that an axis holds goes up to its clearance height over the work first, where
    /// it is lower.</summary>
    /// <param name="goal">Counts of the controller; its height is not looked at.</param>
    public static MachineMove GoTo(CountsPoint goal, MachineProfile profile, string journal, IProgress<JobProgress> progress)
    {
        var flat = To(goal, withHeight: false, isStep: false, profile, journal, progress);
        return profile.Height is null ? flat : flat with
        {
            Refuse = (memory, place) => flat.Refuse(memory, place) ?? WorkPlacement.Over(memory, place, profile).Refusal,
            Aim = (memory, place) => To(goal with { Z = WorkPlacement.Over(memory, place, profile).Height!.Value }, withHeight: true, isStep: false, profile, journal, progress),
        };
    }

    /// <summary>As long as a key is held.</summary>
    public static MachineMove Jog(JogControl control, string journal, IProgress<JobProgress> progress) => new(
        "CNCJOG",
        Wording.Get("MachineSession.Jogging"),
        journal,
        (_, _) => null,
        (machine, program, options, stop) => machine.JogAsync(program, control, options, progress, stop));

    /// <summary>Jogs one after the other.</summary>
    public static MachineMove StandBy(JogStandby standby, string journal, IProgress<JobProgress> progress) => new(
        "CNCJOG",
        Wording.Get("MachineSession.Jogging"),
        journal,
        (_, _) => null,
        (machine, program, options, stop) => machine.StandByAsync(program, standby, options, progress, stop));

    /// <summary>A test move to a place, counts of the controller, whatever is known of the origins.</summary>
    /// <param name="known">The machine's own profile, by which it was homed and which tells its travel in millimetres.</param>
    public static MachineMove Test(CountsPoint goal, MachineProfile known, string journal, IProgress<JobProgress> progress) => new(
        "CNCCOMMISSION",
        Wording.Get("MachineSession.Positioning"),
        journal,
        (memory, place) => memory.KnowsTravel(known, place) ? TravelLimits.Refusal(known, goal, withHeight: true) : null,
        (machine, program, options, stop) => machine.GoToAsync(program, goal, withHeight: true, options, progress, stop)) { Known = known };

    /// <summary>Along a path from where the machine stands, tool off.</summary>
    /// <param name="known">The machine's own profile, by which it was homed.</param>
    public static MachineMove Path(MotionProgram path, MachineProfile known, string journal, IProgress<JobProgress> progress) => new(
        "CNCCOMMISSION",
        Wording.Get("MachineSession.Positioning"),
        journal,
        (memory, place) => memory.KnowsTravel(known, place) ? TravelLimits.Refusal(known, path, place.Position, dryRun: true) : null,
        (machine, _, options, stop) => machine.RunAsync(path, options, progress, stop)) { Known = known };

    /// <summary>The tool's output on for the settle time, at standstill.</summary>
    /// <param name="known">The machine's own profile, by which it was homed.</param>
    public static MachineMove Pulse(MachineProfile known, string journal) => new(
        "CNCCOMMISSION",
        Wording.Get("MachineSession.OutputTest"),
        journal,
        (_, _) => null,
        (machine, program, options, stop) => machine.Setup!.PulseAsync(program, options with { DryRun = false }, stop)) { Known = known };

    /// <param name="hold">The reservation of the machine by this host, with what is kept of it.</param>
    /// <param name="start">Where the machine stands, in the frame in which progress is reported.</param>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The link never came up.</exception>
    public async Task<JobResult> RunAsync(MachineConnection connection, MachineHold hold, MachineProfile profile, CountsPoint start, CancellationToken stop)
    {
        using var clock = connection.TakeClock();
        await using var machine = await clock.ShakeHandsAsync(connection, trace: null, stop).ConfigureAwait(false);
        var place = await machine.LocateAsync(profile.Axes, stop).ConfigureAwait(false);
        hold.Recognise(place);
        var aimed = this;
        var refused = Refuse(hold.Memory, place);
        if (refused is null && Aim is not null) refused = (aimed = Aim(hold.Memory, place)).Refuse(hold.Memory, place);
        if (refused is { } refusal) return JobResult.NotStarted(0, refusal.Message) with { Diagnostics = [refusal] };
        var known = Known ?? profile;
        var speed = HandSpeed.Fastest(profile, profile.HasHoming ? hold.Memory.IsHomedAt(known, place) : null);
        if (hold.KeepMoving() is { } failure) throw MachineMemoryException.NotWritten(failure);
        var options = new JobOptions
        {
            JournalPath = Journal,
            Address = connection.Description,
            DrawingName = Name,
            DryRun = true,
            SoftLimits = hold.Memory.KnowsTravel(known, place) ? TravelLimits.Of(profile) : [],
        };
        var result = await aimed.Make(machine, new MotionProgram(profile with { RapidMmPerMinute = speed }, start, []), options, stop).ConfigureAwait(false);
        return hold.KeepEnd(result) is { } unkept ? result with { Diagnostics = [.. result.Diagnostics, PreparationRules.StateNotKept.At(default, unkept)] } : result;
    }
}
