using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Sessions;
using Engraver.Links;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>The watchdog in the controller allows 1.0 s of the controller's own clock, at any speed, for a host in another process that has the clock
/// (<c>?clock=PORT</c>) and ends.</summary>
public class WatchdogSpeedTests
{
    private const byte Tool = 1;

    /// <summary>Time of the watchdog; one additional sample for each of its lines, and the time by which the last heartbeat was early.</summary>
    private const int AllowedSamples = 1000;
    private const int LineSamples = 20;
    private const int HeartbeatSamples = 250;

    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(40);

    [Theory]
    [InlineData("1", JobMode.Stream)]
    [InlineData("20", JobMode.Calls)]
    [InlineData("200", JobMode.Stream)]
    [InlineData("200", JobMode.Program)]
    [InlineData("max", JobMode.Stream)]
    [InlineData("max", JobMode.Calls)]
    [InlineData("max", JobMode.Program)]
    public async Task A_dead_host_is_found_after_a_second_of_the_controllers_clock(string speed, JobMode mode)
    {
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = speed == "max" ? double.PositiveInfinity : double.Parse(speed, CultureInfo.InvariantCulture) });
        var place = await controller.ListenTcpAsync(0, patience.Token);
        var clock = SharedClock.Acquire((await controller.ListenClockAsync(patience.Token)).Port);
        var host = new DyingHost();
        var died = 0L;
        var death = new CancelWhen(progress => progress.X > 5000, () =>
        {
            died = controller.Status.Sample;
            host.Die();
        });
        await using var session = await ControllerSession.OpenAsync(
            async cancellation => host.Over(new ClockedLink(await TcpLink.ConnectAsync("127.0.0.1", place.Port, s_patience, TimeProvider.System, cancellation), clock.Invalidate)), new SessionOptions(), clock, patience.Token);

        var result = await JobRunner.RunAsync(MotionPrograms.LongLine(400000), session, SimulatedBench.Job with { Strategy = mode.Strategy() }, death, patience.Token).WaitAsync(patience.Token);
        clock.Dispose(); // the end of the process closes its connection to the clock
        await controller.WaitUntilAsync(status => (status.Outputs & Tool) == 0 && !status.IsMoving, patience.Token);

        Assert.Equal(JobOutcome.LinkLost, result.Outcome);
        var record = controller.Record.Snapshot();
        Assert.Contains(record, sample => sample.Sample == died && (sample.Outputs & Tool) != 0);
        var off = record.First(sample => sample.Sample > died && (sample.Outputs & Tool) == 0).Sample;
        Assert.InRange(off - died, AllowedSamples - HeartbeatSamples, AllowedSamples + LineSamples);
    }

    /// <summary>Its process is killed: nothing more is sent or received.</summary>
    private sealed class DyingHost
    {
        private volatile bool _isDead;

        public void Die() => _isDead = true;

        public IControllerLink Over(IControllerLink link) => new Dying(link, this);

        private sealed class Dying(IControllerLink inner, DyingHost host) : IControllerLink
        {
            public string Description => inner.Description;

            public SerialLine? Line => inner.Line;

            public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation) => host._isDead ? throw new IOException("dead") : inner.WriteAsync(bytes, cancellation);

            public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => host._isDead ? throw new IOException("dead") : inner.ReadAsync(buffer, cancellation);

            public ValueTask DisposeAsync() => inner.DisposeAsync();
        }
    }
}
