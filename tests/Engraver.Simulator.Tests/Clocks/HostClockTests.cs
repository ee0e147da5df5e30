using System.Net.Sockets;
using System.Text;

namespace Engraver.Simulator.Tests.Clocks;

/// <summary>The clock that is given to a host: time advances only through its commands and while it waits (docs/simulator-fidelity.md, "The clock").</summary>
public class HostClockTests
{
    private const string MovingUnderWatchdog = "VMAB;VS 20000;VP 100000,0;VE;SB1;BGS";

    private static readonly TimeSpan s_patience = TimeSpan.FromMinutes(1);

    [Fact]
    public async Task A_wait_passes_its_time_to_the_tick_and_nothing_else_does()
    {
        await using var rig = new SimulatorRig();
        using var clock = rig.Controller.JoinClock();
        rig.Do("SPA=10000", "PRA=5000", "BGA");
        var begun = rig.Controller.Status.Sample;

        rig.Time.Advance(TimeSpan.FromSeconds(9));
        Assert.Equal(begun, rig.Controller.Status.Sample);
        await WaitAsync(clock, TimeSpan.FromMilliseconds(250));
        Assert.Equal(begun + 250, rig.Controller.Status.Sample);
        await WaitAsync(clock, TimeSpan.FromHours(10));
        Assert.Equal(begun + 250 + 36_000_000, rig.Controller.Status.Sample);
        Assert.Equal(5000, rig.Value("_RPA"));
    }

    [Fact]
    public async Task Commands_take_their_time_on_the_clock()
    {
        await using var rig = new SimulatorRig();
        using var clock = rig.Controller.JoinClock();
        var begun = clock.GetTimestamp();

        for (var i = 0; i < 10; i++) rig.Do("x=1");

        Assert.Equal(TimeSpan.FromMilliseconds(16), clock.GetElapsedTime(begun));
    }

    /// <summary>Regression: beside busy processes a host that computed for ten seconds lost this time, and its watchdog tripped. A host in this process is late
    /// only when the process is.</summary>
    [Theory]
    [InlineData(1.0)]
    [InlineData(20.0)]
    [InlineData(double.PositiveInfinity)]
    public async Task A_host_of_this_process_that_is_late_is_waited_for_at_every_speed(double speed)
    {
        var wall = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = speed, Time = wall });
        await using var link = controller.OpenConnection();
        using var clock = controller.JoinClock();
        SimulatorRig.Exchange(link, $"DL\r{ExamplePrograms.Watchdog.ReplaceLineEndings("\r")}\\XQ#WDOG,1\rhb=20\r{MovingUnderWatchdog}\rMG _R"); // and half a command
        var late = controller.Status.Sample;

        for (var step = 0; step < 36_000; step++) wall.Advance(TimeSpan.FromMilliseconds(100)); // an hour

        Assert.Equal((late, 1, true), (controller.Status.Sample, (int)controller.Status.Outputs, controller.Status.IsMoving));
    }

    [Fact]
    public async Task A_host_that_gave_the_clock_back_is_found_by_the_watchdog_after_one_second_of_the_controllers_clock()
    {
        await using var rig = new SimulatorRig();
        var clock = rig.Controller.JoinClock();
        rig.Download(ExamplePrograms.Watchdog).Do("XQ#WDOG,1", "hb=20").Ask(MovingUnderWatchdog);
        var death = rig.Controller.Status.Sample;
        clock.Dispose();

        for (var step = 0; step < 200; step++) rig.Time.Advance(TimeSpan.FromMilliseconds(100));

        Assert.InRange(FirstWithToolOff(rig, death).Sample - death, 950, 1050);
    }

    /// <summary>ADR 5: with the clock of another process or without one, a host that hangs trips its watchdog.</summary>
    [Theory]
    [InlineData(true, double.PositiveInfinity)]
    [InlineData(true, 20.0)]
    [InlineData(false, 1.0)]
    [InlineData(false, double.PositiveInfinity)]
    public async Task A_host_of_another_process_that_hangs_is_found_by_the_watchdog_after_one_second_of_the_controllers_clock(bool hasClock, double speed)
    {
        using var limit = new CancellationTokenSource(s_patience);
        var wall = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = speed, Time = wall });
        using var host = await TcpClientEnd.ConnectAsync(await controller.ListenTcpAsync(0, limit.Token), limit.Token);
        using var clock = new TcpClient();
        if (hasClock)
        {
            await clock.ConnectAsync(await controller.ListenClockAsync(limit.Token), limit.Token);
            await clock.GetStream().WriteAsync("now\n"u8.ToArray(), limit.Token);
            Assert.Equal("0", await new StreamReader(clock.GetStream(), Encoding.ASCII).ReadLineAsync(limit.Token));
        }

        foreach (var line in new[] { $"DL\r{ExamplePrograms.Watchdog.ReplaceLineEndings("\r")}\\", "XQ#WDOG,1", "hb=20", MovingUnderWatchdog }) await host.AskAsync(line, limit.Token);
        var moving = await controller.WaitUntilAsync(status => status is { Outputs: 1, IsMoving: true }, limit.Token);

        for (var step = 0; step < 200; step++) wall.Advance(TimeSpan.FromMilliseconds(100));

        Assert.InRange(controller.Record.Snapshot().First(sample => sample.Sample > moving.Sample && sample.Outputs == 0).Sample - moving.Sample, 950, 1050);
    }

    [Fact]
    public async Task Two_hosts_are_both_waited_for()
    {
        await using var rig = new SimulatorRig();
        using var first = rig.Controller.JoinClock();
        using var second = rig.Controller.JoinClock();

        var early = WaitAsync(first, TimeSpan.FromMilliseconds(30));
        Assert.Equal((false, 0), (early.IsCompleted, rig.Controller.Status.Sample));
        var late = WaitAsync(second, TimeSpan.FromMilliseconds(50));
        await early;
        Assert.Equal((false, 30), (late.IsCompleted, rig.Controller.Status.Sample)); // the first is active again
        var again = WaitAsync(first, TimeSpan.FromMilliseconds(100));
        await late;
        Assert.Equal((false, 50), (again.IsCompleted, rig.Controller.Status.Sample));
        second.Dispose();
    }

    [Fact]
    public async Task A_wait_that_is_cancelled_leaves_the_host_at_work()
    {
        await using var rig = new SimulatorRig();
        using var first = rig.Controller.JoinClock();
        using var second = rig.Controller.JoinClock();
        using var stop = new CancellationTokenSource();
        var given = WaitAsync(first, TimeSpan.FromMilliseconds(30), stop.Token);
        await stop.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => given);

        var other = WaitAsync(second, TimeSpan.FromMilliseconds(50));

        Assert.Equal((false, 0), (other.IsCompleted, rig.Controller.Status.Sample));
    }

    [Fact]
    public async Task A_deadline_fires_when_time_passes_it_and_lets_none_pass()
    {
        await using var rig = new SimulatorRig();
        using var clock = rig.Controller.JoinClock();
        var fired = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        await using var deadline = clock.CreateTimer(_ => fired.TrySetResult(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);

        deadline.Change(TimeSpan.FromMilliseconds(20), Timeout.InfiniteTimeSpan);
        Assert.Equal(0, rig.Controller.Status.Sample);
        await WaitAsync(clock, TimeSpan.FromMilliseconds(19));
        Assert.False(fired.Task.IsCompleted);
        await WaitAsync(clock, TimeSpan.FromMilliseconds(1));
        await fired.Task;
    }

    [Theory]
    [InlineData(20.0)]
    [InlineData(200.0)]
    public async Task A_finite_speed_holds_a_waiting_host_back_to_the_wall(double speed)
    {
        var wall = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = speed, Time = wall });
        using var clock = controller.JoinClock();
        wall.Advance(TimeSpan.FromSeconds(5)); // at work
        Assert.Equal(0, controller.Status.Sample);

        var wait = WaitAsync(clock, TimeSpan.FromSeconds(0.2 * speed));
        wall.Advance(TimeSpan.FromSeconds(0.1));
        Assert.InRange(controller.Status.Sample, 99 * speed, 161 * speed); // twice the leeway of 20 ms: the host was active, and waits may run ahead
        Assert.False(wait.IsCompleted);
        wall.Advance(TimeSpan.FromSeconds(0.1));
        await wait;
        Assert.Equal(200 * speed, controller.Status.Sample);
    }

    /// <summary>The case of a host that continues before its cancelled wait is disposed.</summary>
    [Fact]
    public async Task A_wait_that_is_given_up_leaves_one_that_began_behind_it()
    {
        var wall = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20.0, Time = wall });
        using var clock = controller.JoinClock();
        var given = clock.CreateTimer(_ => { }, null, TimeSpan.FromSeconds(100), Timeout.InfiniteTimeSpan);
        var second = WaitAsync(clock, TimeSpan.FromSeconds(2));
        await given.DisposeAsync();

        for (var step = 0; step < 10; step++) wall.Advance(TimeSpan.FromSeconds(0.1));

        await second.WaitAsync(TimeSpan.FromMinutes(1));
    }

    [Fact]
    public async Task A_host_that_waits_for_an_answer_which_never_comes_reaches_its_time_out()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Faults = new FaultPlan { FreezeAfterCommands = 1 } });
        using var clock = rig.Controller.JoinClock();
        var fired = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        await using var deadline = clock.CreateTimer(_ => fired.TrySetResult(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
        deadline.Change(TimeSpan.FromSeconds(2), Timeout.InfiniteTimeSpan);
        rig.Do("x=1");
        Assert.Equal("", rig.Ask("x=2"));
        for (var step = 0; step < 40; step++) rig.Time.Advance(TimeSpan.FromMilliseconds(100));
        Assert.False(fired.Task.IsCompleted); // it may be late and read soon

        var reading = rig.Stream.ReadAsync(new byte[1]);
        for (var step = 0; step < 40; step++) rig.Time.Advance(TimeSpan.FromMilliseconds(100));

        await fired.Task;
        Assert.False(reading.IsCompleted);
    }

    [Fact]
    public async Task Whatever_holds_the_host_up_the_record_is_the_same()
    {
        var expected = await RecordAsync(0);
        for (var seed = 1; seed <= 20; seed++) Assert.Equal(expected, await RecordAsync(seed));
    }

    [Fact]
    public async Task The_clock_over_a_socket_gives_the_time_waits_and_is_given_back()
    {
        await using var rig = new SimulatorRig();
        var place = await rig.Controller.ListenClockAsync(CancellationToken.None);
        using (var client = new TcpClient())
        {
            await client.ConnectAsync(place);
            using var reader = new StreamReader(client.GetStream(), Encoding.ASCII);
            async Task<string?> AskAsync(string line)
            {
                await client.GetStream().WriteAsync(Encoding.ASCII.GetBytes(line + "\n"));
                return await reader.ReadLineAsync();
            }

            Assert.Equal("0", await AskAsync("now"));
            Assert.Equal("200", await AskAsync("wait 200")); // less than a sample
            Assert.Equal("1500000", await AskAsync("wait 1499800"));
            rig.Time.Advance(TimeSpan.FromSeconds(1));
            Assert.Equal("1500000", await AskAsync("stop\nnow")); // there was no wait to stop
            rig.Download("WT 60000\nn=1\nEN").Do("n=0", "XQ");
            Assert.Equal(0, rig.Value("n"));
            Assert.Null(await AskAsync("later"));
        }

        rig.Time.Advance(TimeSpan.FromSeconds(1));
        Assert.Equal(1, rig.Value("n"));
    }

    [Fact]
    public async Task A_wait_over_a_socket_is_ended_by_stop_and_by_the_end_of_the_controller()
    {
        var rig = new SimulatorRig();
        var place = await rig.Controller.ListenClockAsync(CancellationToken.None);
        var other = rig.Controller.JoinClock(); // a second host that is active: no time passes
        using var client = new TcpClient();
        await client.ConnectAsync(place);
        using var reader = new StreamReader(client.GetStream(), Encoding.ASCII);
        async Task SayAsync(string lines) => await client.GetStream().WriteAsync(Encoding.ASCII.GetBytes(lines));
        async Task<string?> HearAsync() => await reader.ReadLineAsync().WaitAsync(s_patience);

        for (var time = 0; time < 20; time++)
        {
            await SayAsync("wait 1000000\nstop\n");
            Assert.Equal("0", await HearAsync());
        }

        other.Dispose();
        await SayAsync("wait 5000\n"); // after it: the rest of a running wait passes by the wall clock, which does not advance here
        Assert.Equal("5000", await HearAsync());
        using var third = rig.Controller.JoinClock();
        await SayAsync("wait 1000000\n");
        await rig.DisposeAsync();

        Assert.Null(await EndOfAsync(reader).WaitAsync(s_patience));
    }

    /// <summary>The remaining output of a connection; null when it is closed, also by a reset.</summary>
    private static async Task<string?> EndOfAsync(StreamReader reader)
    {
        try
        {
            return await reader.ReadLineAsync();
        }
        catch (IOException)
        {
            return null;
        }
    }

    /// <summary>The same commands and waits, with the host delayed at random between them: by the wall clock and by other threads.</summary>
    private static async Task<MotionSample[]> RecordAsync(int seed)
    {
        var random = new Random(seed);
        await using var rig = new SimulatorRig();
        using var clock = rig.Controller.JoinClock();
        async Task StallAsync()
        {
            if (seed == 0) return;
            rig.Time.Advance(TimeSpan.FromMilliseconds(random.Next(3000)));
            if (random.Next(2) == 0) await Task.Yield();
        }

        rig.Download(ExamplePrograms.Watchdog).Do("XQ#WDOG,1", "hb=20", "VMAB", "VS 20000", "VP 20000,0", "CR 5000,0,180", "VE", "SB1", "BGS");
        for (var look = 0; look < 40; look++)
        {
            await StallAsync();
            await WaitAsync(clock, TimeSpan.FromMilliseconds(37));
            await StallAsync();
            rig.Ask("MG _RPA,_RPB");
            await StallAsync();
            rig.Do("hb=20");
        }

        return [.. rig.Controller.Record.Snapshot()];
    }

    /// <summary>A wait of the host: a timer that is created with its due time.</summary>
    private static async Task WaitAsync(TimeProvider clock, TimeSpan time, CancellationToken stop = default)
    {
        var passed = new TaskCompletionSource();
        await using var wait = clock.CreateTimer(_ => passed.TrySetResult(), null, time, Timeout.InfiniteTimeSpan);
        await using var ended = stop.Register(() => passed.TrySetCanceled(stop));
        await passed.Task;
    }

    private static MotionSample FirstWithToolOff(SimulatorRig rig, long from) => rig.Controller.Record.Snapshot().First(sample => sample.Sample > from && sample.Outputs == 0);
}
