using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>The paper's method, corrected (paper 001; galil-dmc.md F.0, EX11): #LINEAR and #CIRC in the controller are called for each segment with
/// assigned variables,
/// relative to the machine's actual position, with a full stop after each. Progress is counted by <c>seq</c>, because <c>done</c> alone is a race
/// (F.3).</summary>
internal sealed class CallsStrategy(JobMachine machine, JobLedger ledger) : ISequenceStrategy
{
    private readonly AngleQuantum _quantum = new(machine.Profile.AngleQuantumDegrees);

    /// <summary>The server clears go and the arguments when it starts, and then sets up the machine: an empty call that is completed shows that it has done
    /// both.</summary>
    public async ValueTask<JobStep> StartAsync()
    {
        if (await machine.AwaitAsync(ResidentProgram.Variables.Done, value => value != 0).ConfigureAwait(false) is { Ends: true } end) return end;
        if (await machine.SendAsync(ResidentServer.GoCommand).ConfigureAwait(false) is { Ends: true } refused) return refused;
        machine.Hold.AwaitIdle = () => machine.AwaitAsync(ResidentProgram.Variables.Done, value => value != 0);
        return await machine.PollUntilAsync(state => state.Calls != 0).ConfigureAwait(false);
    }

    public async ValueTask<JobStep> CutAsync(VectorSequence sequence)
    {
        if (await machine.PollUntilAsync(state => state.Stands).ConfigureAwait(false) is { Ends: true } end) return end;
        var start = sequence.Start;
        machine.Hold.Speed.Bear(machine.Profile, [sequence], hostFeeds: false);
        foreach (var segment in sequence.Segments)
        {
            if (await CallAsync(segment, start, sequence.Speed).ConfigureAwait(false) is { Ends: true } broken) return broken;
            start = segment.End;
        }

        return JobStep.Done;
    }

    /// <summary>A call that the stop interrupted is not counted here, although the program counts it when its motion has come to rest.</summary>
    public void StoppedAt(int counter)
    {
    }

    private async ValueTask<JobStep> CallAsync(VectorSegment planned, CountsPoint start, int speed)
    {
        var here = machine.Here with { Z = start.Z }; // the tool is brought to this height before the call
        var segment = SegmentFromHere.Aim(planned, start, here, _quantum);
        if (segment.Kind == VectorSegmentKind.Line && segment.End == here)
        {
            ledger.Confirm(segment);
            return JobStep.Done;
        }

        var arguments = ResidentServer.Arguments(segment, here, speed);
        var where = Wording.Get("Execution.DrawingEntity", segment.EntityIndex);
        if (await machine.SendAsync(arguments, where).ConfigureAwait(false) is { Ends: true } refused) return refused;
        if (await SettingCheck.ReadBackAsync(machine, ResidentServer.Held(segment, here, speed)).ConfigureAwait(false) is { Ends: true } harmed) return harmed;
        if (await machine.Hold.ToolOnAsync(start).ConfigureAwait(false) is { Ends: true } end) return end;
        var calls = machine.State.Calls;
        var before = ledger.Executed;
        if (await machine.OpenAsync(before, [0, 1], calls).ConfigureAwait(false) is { Ends: true } unopened) return unopened;
        machine.SegmentsDone = state => before + (state.Calls != calls && state.StopCode == StopCodes.SequenceEnded ? 1 : 0);
        if (await machine.SendAsync(ResidentServer.GoCommand, where).ConfigureAwait(false) is { Ends: true } unstarted) return unstarted;
        ledger.Sent++;
        var watch = machine.Watch(here, [segment], speed);
        machine.Expectation = state => state.SequenceRunning ? watch.Look(0, machine.Here) : JobStep.Done;
        machine.Feed.Planned = state => state.Calls == calls ? PlannedSpeed.Of(speed) : null;
        try
        {
            if (await machine.PollUntilAsync(state => state.Calls != calls, SpeedTrapezoid.Time(segment.Length, speed, machine.Profile.AccelerationCounts)).ConfigureAwait(false) is { Ends: true } broken) return broken;
        }
        finally
        {
            machine.Expectation = null;
            machine.Feed.Planned = null;
            machine.SegmentsDone = null;
        }

        return await CheckAsync(segment, watch).ConfigureAwait(false);
    }

    private async ValueTask<JobStep> CheckAsync(VectorSegment segment, PathWatch watch)
    {
        var state = machine.State;
        if (state.StopCode != StopCodes.SequenceEnded)
            return JobStep.Broken(Wording.Get("CallsStrategy.CallEndedEarly", segment.EntityIndex, state.Position.X, state.Position.Y, await machine.WhyStoppedAsync().ConfigureAwait(false)));
        if (watch.LookAtEnd(machine.Here) is { Ends: true } elsewhere) return elsewhere;
        ledger.Confirm(segment);
        return JobStep.Done;
    }
}
