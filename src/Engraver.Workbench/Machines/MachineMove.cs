using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>One manual move of a connected machine.</summary>
/// <param name="Name">Name in the journal.</param>
/// <param name="Doing">Displayed state during the move.</param>
/// <param name="Journal">Path of the journal that stores the initial state of the controller for recovery after a crash.</param>
/// <param name="Refuse">Returns why the move is refused for the machine's position; null: allowed.</param>
/// <param name="Make">Executes the motion; its options contain the active soft limits.</param>
internal sealed record MachineMove(
    string Name, string Doing, string Journal, Func<StoredMachineState, ControllerPosition, Diagnostic?> Refuse, Func<IMachineConnection, MotionProgram, JobOptions, CancellationToken, Task<JobResult>> Make)
{
    /// <summary>Returns the actual move after the machine's position is known; null: this move. Called only if <see cref="Refuse"/> allows it.</summary>
    private Func<StoredMachineState, ControllerPosition, MachineMove>? Resolve { get; init; }

    /// <summary>The machine's own profile, by which it was homed, if the move uses another one; otherwise null.</summary>
    private MachineProfile? Known { get; init; }

    /// <summary>A move to a position, counts of the controller.</summary>
    /// <param name="withHeight">Z moves too; otherwise it is unchanged.</param>
    /// <param name="isStep">The position is relative to the current one, so the machine need not be homed.</param>
    public static MachineMove To(CountsPoint goal, bool withHeight, bool isStep, MachineProfile profile, string journal, IProgress<JobProgress> progress) => new(
        isStep ? "CNCJOG" : "CNCGOTO",
        isStep ? Wording.Get("MachineSession.Jogging") : Wording.Get("MachineSession.Positioning"),
        journal,
        (memory, place) => (isStep ? null : WorkPlacement.NotHomed(memory, place, profile)) switch
        {
            { } unhomed => unhomed,
            _ when memory.IsTravelKnown(profile, place) => TravelLimits.Refusal(profile, goal, withHeight),
            _ when isStep => TravelLimits.StepRefusal(profile, goal - place.Position, withHeight),
            _ => memory.Lost.Length > 0 ? PreparationRules.PositionDoubted.At(default, memory.Lost) : null,
        },
        (machine, program, options, stop) => machine.GoToAsync(program, goal, withHeight, options, progress, stop));

    /// <summary>A move to an XY position relative to the controller's zero. A tool axis below the clearance height is raised first.</summary>
    /// <param name="goal">Counts of the controller; its height is ignored.</param>
    public static MachineMove GoTo(CountsPoint goal, MachineProfile profile, string journal, IProgress<JobProgress> progress)
    {
        var flat = To(goal, withHeight: false, isStep: false, profile, journal, progress);
        return profile.Height is null ? flat : flat with
        {
            Refuse = (memory, place) => flat.Refuse(memory, place) ?? WorkPlacement.TravelHeight(memory, place, profile).Refusal,
            Resolve = (memory, place) => To(goal with { Z = WorkPlacement.TravelHeight(memory, place, profile).Height!.Value }, withHeight: true, isStep: false, profile, journal, progress),
        };
    }

    /// <summary>A continuous jog.</summary>
    public static MachineMove Jog(JogControl control, string journal, IProgress<JobProgress> progress) => new(
        "CNCJOG",
        Wording.Get("MachineSession.Jogging"),
        journal,
        (_, _) => null,
        (machine, program, options, stop) => machine.JogAsync(program, control, options, progress, stop));

    /// <summary>A standby for consecutive jogs.</summary>
    public static MachineMove JogStandby(JogStandby standby, string journal, IProgress<JobProgress> progress) => new(
        "CNCJOG",
        Wording.Get("MachineSession.Jogging"),
        journal,
        (_, _) => null,
        (machine, program, options, stop) => machine.StandByAsync(program, standby, options, progress, stop));

    /// <summary>A test move to a position, counts of the controller, independent of the origins.</summary>
    /// <param name="known">The machine's own profile, by which it was homed and which defines its travel in millimetres.</param>
    public static MachineMove Test(CountsPoint goal, MachineProfile known, string journal, IProgress<JobProgress> progress) => new(
        "CNCCOMMISSION",
        Wording.Get("MachineSession.Positioning"),
        journal,
        (memory, place) => memory.IsTravelKnown(known, place) ? TravelLimits.Refusal(known, goal, withHeight: true) : null,
        (machine, program, options, stop) => machine.GoToAsync(program, goal, withHeight: true, options, progress, stop)) { Known = known };

    /// <summary>A move along a path from the current position, tool off.</summary>
    /// <param name="known">The machine's own profile, by which it was homed.</param>
    public static MachineMove Path(MotionProgram path, MachineProfile known, string journal, IProgress<JobProgress> progress) => new(
        "CNCCOMMISSION",
        Wording.Get("MachineSession.Positioning"),
        journal,
        (memory, place) => memory.IsTravelKnown(known, place) ? TravelLimits.Refusal(known, path, place.Position, dryRun: true) : null,
        (machine, _, options, stop) => machine.RunAsync(path, options, progress, stop)) { Known = known };

    /// <summary>Switches the tool output on for the settle time, at standstill.</summary>
    /// <param name="known">The machine's own profile, by which it was homed.</param>
    public static MachineMove Pulse(MachineProfile known, string journal) => new(
        "CNCCOMMISSION",
        Wording.Get("MachineSession.OutputTest"),
        journal,
        (_, _) => null,
        (machine, program, options, stop) => machine.Setup!.PulseAsync(program, options with { DryRun = false }, stop)) { Known = known };

    /// <param name="lease">The lease of the machine with its stored state.</param>
    /// <param name="start">Start position in the frame of the reported progress.</param>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The link could not be established.</exception>
    public async Task<JobResult> RunAsync(MachineConnection connection, MachineLease lease, MachineProfile profile, CountsPoint start, CancellationToken stop)
    {
        using var clock = connection.CreateClock();
        await using var machine = await clock.HandshakeAsync(connection, trace: null, stop).ConfigureAwait(false);
        var place = await machine.ReadPositionAsync(profile.Axes, stop).ConfigureAwait(false);
        lease.CompareZero(place);
        var aimed = this;
        var refused = Refuse(lease.Memory, place);
        if (refused is null && Resolve is not null) refused = (aimed = Resolve(lease.Memory, place)).Refuse(lease.Memory, place);
        if (refused is { } refusal) return JobResult.NotStarted(0, refusal.Message) with { Diagnostics = [refusal] };
        var known = Known ?? profile;
        var speed = HandSpeed.Max(profile, profile.HasHoming ? lease.Memory.IsHomedAt(known, place) : null);
        if (lease.NoteMoving() is { } failure) throw MachineMemoryException.NotWritten(failure);
        var options = new JobOptions
        {
            JournalPath = Journal,
            Address = connection.Description,
            DrawingName = Name,
            DryRun = true,
            SoftLimits = lease.Memory.IsTravelKnown(known, place) ? TravelLimits.Of(profile) : [],
        };
        var result = await aimed.Make(machine, new MotionProgram(profile with { RapidMmPerMinute = speed }, start, []), options, stop).ConfigureAwait(false);
        return lease.NoteMotionEnd(result) is { } unkept ? result with { Diagnostics = [.. result.Diagnostics, PreparationRules.StateNotKept.At(default, unkept)] } : result;
    }
}
