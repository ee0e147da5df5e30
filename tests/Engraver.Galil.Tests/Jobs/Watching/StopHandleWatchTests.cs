using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Links;
using Engraver.Links;

namespace Engraver.Galil.Tests.Jobs.Watching;

/// <summary>The handle of the stop is cut in the middle of a job: the operator is notified, and the stop still works.</summary>
public class StopHandleWatchTests
{
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_lost_stop_handle_is_opened_again_and_told(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var links = new List<WithheldLink>();
        await using var session = await bench.OpenAsync(opened: links.Add);
        var cut = new CancelWhen(progress => progress.X > 20000, () => Cut(links[1]));

        var result = await JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, SimulatedBench.Job with { Strategy = mode.Strategy() }, cut, CancellationToken.None);

        Assert.Equal((JobOutcome.Complete, "MOT0021"), (result.Outcome, Assert.Single(result.Diagnostics).Id));
        Assert.Equal((3, false), (links.Count, session.StopHandle.IsBroken));
        Assert.NotSame(session.Commands, session.StopHandle);
    }

    [Fact]
    public async Task When_it_cannot_be_opened_the_stop_goes_over_the_first_handle()
    {
        await using var bench = new SimulatedBench();
        var links = new List<WithheldLink>();
        await using var session = await ControllerSession.OpenAsync(
            _ =>
            {
                if (links.Count == 2) throw new IOException("no handle is free");
                links.Add(new WithheldLink(new StreamLink(bench.Controller.OpenConnection(), "memory")));
                return Task.FromResult<IControllerLink>(links[^1]);
            },
            new SessionOptions(),
            bench.Clock,
            CancellationToken.None);
        using var stop = new CancellationTokenSource();
        var cut = new CancelWhen(progress => progress.X > 20000, () => Cut(links[1]));
        var press = new CancelWhen(progress => progress.X > 150000, stop.Cancel);

        var result = await JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, SimulatedBench.Job, new ProgressPair(cut, press), stop.Token);

        Assert.Equal((JobOutcome.Stopped, "MOT0022"), (result.Outcome, Assert.Single(result.Diagnostics).Id));
        Assert.Contains("no handle is free", result.Diagnostics[0].Message, StringComparison.Ordinal);
        Assert.Equal((false, 0), (bench.Controller.Status.IsMoving, bench.Controller.Status.Outputs));
    }

    private static void Cut(WithheldLink link) => _ = link.DisposeAsync().AsTask();
}
