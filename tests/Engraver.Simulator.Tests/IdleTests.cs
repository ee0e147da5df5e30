namespace Engraver.Simulator.Tests;

/// <summary>An idle controller takes no processor time, and misses no event.</summary>
public class IdleTests
{
    [Theory]
    [InlineData(1.0)]
    [InlineData(100.0)]
    [InlineData(double.PositiveInfinity)]
    public async Task While_nothing_moves_and_nobody_talks_no_timer_comes(double speed)
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = speed, Time = time });
        time.Advance(TimeSpan.FromSeconds(10));
        Assert.Equal(0, time.Ticks);

        using var connection = controller.OpenConnection();
        Assert.Equal(":::", SimulatorRig.Exchange(connection, "SHA;PRA=1000;BGA\r"));
        time.Advance(TimeSpan.FromSeconds(10));
        Assert.Equal(1000, controller.Record.Snapshot()[^1].A);
        var moved = time.Ticks;
        Assert.True(moved > 0, "the motion was followed");

        time.Advance(TimeSpan.FromHours(1));
        Assert.Equal(moved, time.Ticks);
    }

    [Fact]
    public async Task A_waiting_thread_is_woken_once_and_at_its_time()
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { Time = time });
        using var connection = controller.OpenConnection();
        SimulatorRig.Exchange(connection, "DL\rWT 60000\rSB1\rEN\r\\XQ\r");
        time.Advance(TimeSpan.FromSeconds(59.9));
        Assert.Equal(0, controller.Status.Outputs);
        Assert.InRange(time.Ticks, 1, 3);

        time.Advance(TimeSpan.FromSeconds(0.2));

        Assert.Equal((1, 0), (controller.Status.Outputs, controller.Status.RunningThreads));
        Assert.InRange(controller.Record.Snapshot()[^1].Sample, 60000, 60003);
    }

    [Fact]
    public async Task The_clock_goes_on_while_nobody_looks()
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 5, Time = time });
        using var connection = controller.OpenConnection();
        time.Advance(TimeSpan.FromSeconds(4));

        Assert.Equal(20000, controller.Status.Sample);
        Assert.Equal(" 20000.0000\r\n:", SimulatorRig.Exchange(connection, "MG TIME\r"));
    }
}
