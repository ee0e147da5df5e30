using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Watching;

namespace Engraver.Galil.Jobs;

/// <summary>What a job is doing: every poll is compared with it, and a hold acts by it. A strategy enters a phase (<see cref="JobMachine.Enter"/>) before
/// a motion begins; leaving it restores the phase around it.</summary>
/// <remarks>Not to be confused with <see cref="Core.Machines.JobPhase"/>, by which the operator sees whether the job is held.</remarks>
internal sealed record Phase
{
    /// <summary>No part of the path is in progress, and this computer commands every motion.</summary>
    public static Phase Idle { get; } = new();

    /// <summary>Compares a polled state with the planned motion: why the job ends, or null where the state is as planned. Null where nothing is
    /// planned.</summary>
    public Func<JobPoll, JobEnd?>? Expected { get; init; }

    /// <summary>The planned speeds of the sequence that a polled state may be in; null where none is planned.</summary>
    public Func<JobPoll, PlannedSpeed?>? Speed { get; init; }

    /// <summary>Segments of the whole program that are done at a polled state; null: those that the ledger counts.</summary>
    public Func<JobPoll, int>? SegmentsDone { get; init; }

    /// <summary>Whether a path at standstill will move when it is released; it will not where the segment buffer has run dry.</summary>
    public Func<JobPoll, bool> WillMove { get; init; } = _ => true;

    /// <summary>The factor, at most 1, by which the feeder slows the path while few segments are buffered.</summary>
    public Func<double> Throttle { get; init; } = () => 1.0;

    /// <summary>The program in the controller that runs this part of the job and switches the tool; null while this computer does both.</summary>
    public ChunkProgress? Program { get; init; }

    /// <summary>Where the program is, added to the report of a motion that it found ended early.</summary>
    public Func<JobPoll, string> Place { get; init; } = _ => "";

    /// <summary>The program waits at its gate for its spindle and not only for a hold: a resume leaves the gate closed.</summary>
    public bool KeepsGate { get; init; }

    /// <summary>Programs in the controller run the whole job, and the spindle is switched on for each of them after it was loaded.</summary>
    public bool TurnsForPrograms { get; init; }

    /// <summary>Waits until the program that this computer calls is ready for the next call; null where no program is called.</summary>
    public Func<ValueTask>? AwaitIdle { get; init; }

    /// <summary>Where a hold that is requested at this state takes effect.</summary>
    public HoldPoint HoldPointAt(in JobPoll state) => Program is not null ? HoldPoint.InProgram : state.SequenceRunning ? HoldPoint.OnPath : HoldPoint.AtGate;
}
