using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>The leased machine and the position that its controller reported last, from which placements are computed without asking again.</summary>
/// <param name="lease">Owned: it is released with this.</param>
/// <param name="place">As it was reported when the machine was leased.</param>
internal sealed class LocatedMachine(MachineLease lease, ControllerPosition place) : IDisposable
{
    private volatile ControllerPosition _place = place;

    public MachineLease Lease => lease;

    /// <summary>Takes a position that the controller has reported now.</summary>
    public void Recognise(ControllerPosition reported)
    {
        _place = reported;
        lease.CompareZero(reported);
    }

    /// <summary>Records what a poll shows: where the machine is, and whether steps may have been lost.</summary>
    /// <param name="isRunning">A motion of this program is under way, which records its end itself.</param>
    public void Record(MachineReading poll, bool isRunning, MachineAxes axes)
    {
        if (!poll.IsMoving) lease.NoteAbruptStop(_place with { Position = poll.Position }, poll.StoppedWithoutRamp);
        if (!isRunning) lease.NotePosition(poll.Position, poll.IsMoving);
        if (string.Concat(poll.MotorsOff.Intersect(_place.WithoutEncoder)) is { Length: > 0 } off) lease.NotePositionLost(Wording.Get("Origins.StepperWasOff", axes.NamesOf(off)));
    }

    /// <summary>Where the active work origin puts a program, by the position that was reported last.</summary>
    /// <param name="dryRun">The tool stays out of the work, which takes a tool on a tool axis higher.</param>
    public PlacementResult Find(MotionProgram program, bool dryRun) => Find(program, dryRun, _place);

    /// <summary>The same by a position that a poll has shown since.</summary>
    /// <param name="polled">The controller's own counts.</param>
    public PlacementResult Find(MotionProgram program, bool dryRun, CountsPoint polled) => Find(program, dryRun, _place with { Mark = lease.IsZeroKnown ? lease.Memory.Mark : null, Clock = null, Position = polled });

    /// <summary>Why the active work origin gives no place for a job; null when it gives one.</summary>
    /// <param name="polled">The controller's own counts.</param>
    public Diagnostic? WhyUnplaced(MachineProfile profile, CountsPoint polled) => Find(new MotionProgram(profile, default, []), dryRun: false, polled).Refusal;

    public void Dispose() => lease.Dispose();

    private PlacementResult Find(MotionProgram program, bool dryRun, ControllerPosition at)
    {
        var found = WorkPlacement.Find(lease.Memory, at, new OriginRequest.ActiveOrigin(), program.Profile, program.Start);
        return program.Strokes.Count == 0 ? found : WorkPlacement.Within(found, program, dryRun, lease.Memory, at);
    }
}
