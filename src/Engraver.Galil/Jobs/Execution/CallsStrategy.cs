using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>The paper's method, corrected (paper 001; galil-dmc.md F.0, EX11): #LINEAR and #CIRC in the controller are called for each segment with
/// assigned variables, relative to the machine's actual position, with a full stop after each. Progress is counted by <c>seq</c>, because <c>done</c>
/// alone is a race (F.3).</summary>
internal sealed class CallsStrategy(JobMachine machine, JobLedger ledger) : ISequenceStrategy
{
    private readonly AngleQuantum _quantum = new(machine.Profile.AngleQuantumDegrees);

    public Phase Whole => Phase.Idle with { AwaitIdle = AwaitDoneAsync };

    /// <summary>The server clears go and the arguments when it starts, and then sets up the machine: an empty call that is completed shows that it has done
    /// both.</summary>
    public async ValueTask StartAsync()
    {
        await AwaitDoneAsync().ConfigureAwait(false);
        await machine.Commands.SendAsync(ResidentServer.GoCommand).ConfigureAwait(false);
        await machine.PollUntilAsync(state => state.Calls != 0).ConfigureAwait(false);
    }

    public async ValueTask CutAsync(VectorSequence sequence)
    {
        await machine.PollUntilAsync(state => state.IsAtRest).ConfigureAwait(false);
        var start = sequence.Start;
        foreach (var segment in sequence.Segments)
        {
            var one = sequence with { Start = start, Segments = [segment] };
            var cut = machine.Speed.Plan(one, hostFeeds: false).Sequence; // from rest to rest: it is not divided
            await CallAsync(segment, start, cut.SpeedOf(cut.Segments[0]), cut.AccelerationOn(machine.Profile)).ConfigureAwait(false);
            start = segment.End;
        }
    }

    /// <summary>A call that the stop interrupted is not counted here, although the program counts it when its motion has come to rest.</summary>
    public void StoppedAt(int counter)
    {
    }

    private ValueTask AwaitDoneAsync() => machine.AwaitAsync(ResidentProgram.Variables.Done, value => value != 0);

    private async ValueTask CallAsync(VectorSegment planned, CountsPoint start, int speed, int acceleration)
    {
        var here = machine.Here with { Z = start.Z }; // the tool is brought to this height before the call
        var segment = SegmentFromPosition.Adapt(planned, start, here, _quantum);
        if (segment.Kind == VectorSegmentKind.Line && segment.End == here)
        {
            ledger.Confirm(segment);
            return;
        }

        var arguments = ResidentServer.Arguments(segment, here, speed, acceleration);
        var where = Wording.Get("Execution.DrawingEntity", segment.EntityIndex);
        await machine.Commands.SendAsync(arguments, where).ConfigureAwait(false);
        await SettingCheck.ReadBackAsync(machine, ResidentServer.Held(segment, here, speed, acceleration)).ConfigureAwait(false);
        await machine.Hold.ToolOnAsync(start).ConfigureAwait(false);
        if (!machine.Hold.IsHoldWanted) await machine.Speed.AdjustAsync().ConfigureAwait(false);
        var (calls, before) = (machine.State.Calls, ledger.Executed);
        await machine.OpenAsync(before, [0, 1], calls).ConfigureAwait(false);
        var watch = machine.WatchPath(here, [segment], speed);
        using (machine.Enter(machine.Phase with
        {
            SegmentsDone = state => before + (state.Calls != calls && state.StopCode == StopCodes.SequenceEnded ? 1 : 0),
            Expected = state => state.SequenceRunning ? watch.Check(0, machine.Here) : null,
            Speed = state => state.Calls == calls ? PlannedSpeed.Of(speed, acceleration) : null,
        }))
        {
            await machine.Commands.SendAsync(ResidentServer.GoCommand, where).ConfigureAwait(false);
            ledger.Sent++;
            await machine.PollUntilAsync(state => state.Calls != calls, SpeedTrapezoid.Time(segment.Length, speed, acceleration)).ConfigureAwait(false);
        }

        await CheckAsync(segment, watch).ConfigureAwait(false);
        ledger.Confirm(segment);
    }

    private async ValueTask CheckAsync(VectorSegment segment, PathWatch watch)
    {
        var state = machine.State;
        if (state.StopCode != StopCodes.SequenceEnded)
            throw JobEnd.Broken(Wording.Get("CallsStrategy.CallEndedEarly", segment.EntityIndex, state.Position.X, state.Position.Y, await machine.Watch.Fault.WhyStoppedAsync().ConfigureAwait(false))).ToException();
        if (watch.LookAtEnd(machine.Here) is { } elsewhere) throw elsewhere.ToException();
    }
}
