using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Tests.Jobs;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Sessions;

/// <summary>Another host uses the controller already.</summary>
public class BusyControllerTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public async Task Without_two_free_handles_it_is_the_handles_that_are_named(int handles)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, HandleCount = handles });
        await using var other = controller.OpenConnection();
        var end = await controller.ListenTcpAsync(0, CancellationToken.None);

        var failure = await Assert.ThrowsAsync<ControllerLinkException>(() => Galil.Sessions.ControllerSession.OpenAsync(
            async cancellation => await Engraver.Links.TcpLink.ConnectAsync("127.0.0.1", end.Port, TimeSpan.FromSeconds(60), TimeProvider.System, cancellation, () => Galil.Sessions.ControllerSession.HandlesTaken),
            new Galil.Sessions.SessionOptions { ReplyTimeout = TimeSpan.FromSeconds(60) },
            TimeProvider.System,
            CancellationToken.None));

        Assert.Contains("handles are in use", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_second_run_is_not_told_to_halt_the_threads_of_the_first()
    {
        await using var bench = new SimulatedBench();
        await using var first = await bench.OpenAsync();
        await using var second = await bench.OpenAsync();
        string? said = null;
        var look = new CancelWhen(progress => progress.X > 20000, () => said = second.BusyReasonAsync(CancellationToken.None).GetAwaiter().GetResult());

        var result = await JobRunner.RunAsync(MotionPrograms.LongLine(100000), first, SimulatedBench.Job, look, CancellationToken.None);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.Contains("Another run of this program", said, StringComparison.Ordinal);
        Assert.DoesNotContain("HX", said, StringComparison.Ordinal);
    }
}
