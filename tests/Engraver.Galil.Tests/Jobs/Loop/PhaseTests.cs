using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Jobs.Journal;

namespace Engraver.Galil.Tests.Jobs.Loop;

/// <summary>A phase is in force until its scope is left, however it is left; then the phase around it is in force again.</summary>
public class PhaseTests
{
    [Fact]
    public async Task Leaving_a_phase_restores_the_one_around_it_also_when_a_step_ends_the_job()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        using var order = new StopOrder(CancellationToken.None);
        using var journal = new JobJournal((string?)null);
        var ledger = new JobLedger(MotionPrograms.Paper);
        var machine = new JobMachine(session, MotionPrograms.Paper, SimulatedBench.Job, ledger, new JobLog(ledger, journal, null, session.Time, null), order);
        Phase outer = Phase.Idle with { KeepsGate = true }, inner = outer with { SegmentsDone = _ => 3 };
        var within = new List<Phase>();

        var end = await JobEnd.OfAsync(OuterAsync);

        Assert.Equal(JobOutcome.Deviated, end!.Outcome);
        Assert.Equal([outer, inner, outer], within);
        Assert.Same(Phase.Idle, machine.Phase);

        async ValueTask OuterAsync()
        {
            using var scope = machine.Enter(outer);
            within.Add(machine.Phase);
            try
            {
                await InnerAsync();
            }
            finally
            {
                within.Add(machine.Phase);
            }
        }

        async ValueTask InnerAsync()
        {
            using var scope = machine.Enter(inner);
            within.Add(machine.Phase);
            await Task.Yield();
            throw JobEnd.Deviated("beside the path").ToException();
        }
    }

    [Theory]
    [InlineData(false, HoldPoint.AtGate)]
    [InlineData(true, HoldPoint.OnPath)]
    public void Where_a_hold_takes_effect_depends_on_the_path(bool isRunning, object at) => Assert.Equal(at, Phase.Idle.HoldPointAt(new JobPoll { SequenceRunning = isRunning }));
}
