namespace Engraver.Simulator.Tests;

/// <summary>How time passes: the contract of "engraver simulate --speed".</summary>
public class TimeTests
{
    private static readonly TimeSpan Silence = TimeSpan.FromMilliseconds(5);

    [Theory]
    [InlineData(1.0, 110)] // a real machine does not wait
    [InlineData(100.0, 2000)]
    public async Task What_computing_takes_does_not_count_where_the_clock_is_to_run_ahead(double speed, int samples)
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = speed, Time = time });
        TimeSpan passed = TimeSpan.FromMilliseconds(10), computing = TimeSpan.FromMilliseconds(90);
        foreach (var delay in speed > 1.0 ? [passed, computing, passed, computing] : new[] { passed, computing + passed }) time.Delays.Enqueue(delay);
        Assert.NotEqual(0, controller.Status.Sample);

        Assert.Equal(samples, controller.Status.Sample);
    }

    [Fact]
    public async Task At_max_every_command_costs_its_time_and_nothing_else_passes()
    {
        await using var rig = new SimulatorRig();
        for (var i = 0; i < 100; i++) rig.Do("x=1");

        Assert.Equal(160, rig.Controller.Status.Sample);
        rig.Time.Advance(TimeSpan.FromHours(1));
        Assert.Equal(160, rig.Controller.Status.Sample);
    }

    [Fact]
    public async Task At_max_silence_carries_the_controller_to_its_next_event()
    {
        await using var rig = new SimulatorRig();
        rig.Download("WT 1000\nn=1\nWT 60000\nn=2\nEN").Do("n=0", "XQ", "PRA=10000", "BGA");

        rig.Time.Advance(Silence);
        Assert.InRange(rig.Controller.Status.Sample, 495, 515); // the move has ended
        rig.Time.Advance(Silence);
        Assert.InRange(rig.Controller.Status.Sample, 1000, 1100);
        Assert.Equal(1, rig.Value("n"));
        rig.Time.Advance(Silence * 2);
        Assert.Equal(2, rig.Value("n"));
        Assert.InRange(rig.Controller.Status.Sample, 61000, 61100);
    }

    [Theory]
    [InlineData("EN", "_RPA", 300000)] // only a motion
    [InlineData("n=0\nWT 5000\nn=7\nEN", "n", 7)] // a program that runs without a host
    public async Task At_max_whoever_sends_many_commands_and_waits_for_their_end_waits_five_milliseconds(string program, string what, double end)
    {
        await using var rig = new SimulatorRig();
        rig.Download(program);
        for (var i = 0; i < 20; i++) rig.Ask("MG _RPA");
        rig.Do("SPA=100000", "ACA=256000", "DCA=256000", "PRA=300000", "BGA", "XQ");

        rig.Time.Advance(TimeSpan.FromMilliseconds(100));

        Assert.Equal(end, rig.Value(what));
    }

    [Fact]
    public async Task At_max_a_display_that_looks_now_and_then_does_not_stop_the_time()
    {
        await using var rig = new SimulatorRig();
        rig.Download("WT 60000\nn=1\nEN").Do("n=0", "XQ");
        for (var i = 0; i < 20; i++) rig.Ask("MG _RPA");
        for (var look = 0; look < 20; look++)
        {
            rig.Time.Advance(TimeSpan.FromMilliseconds(20));
            for (var question = 0; question < 3; question++) rig.Ask("MG _RPA");
        }

        Assert.Equal(1, rig.Value("n"));
    }

    [Fact]
    public async Task At_max_an_open_sequence_waits_two_seconds_for_its_host()
    {
        await using var rig = new SimulatorRig();
        rig.Do("VMAB", "VP 20000,0", "BGS");

        rig.Time.Advance(TimeSpan.FromSeconds(1.9));
        Assert.InRange(rig.Controller.Status.Sample, 4, 6);
        rig.Do("VP 40000,0");
        rig.Time.Advance(TimeSpan.FromSeconds(1.9));
        Assert.Equal(0, rig.Controller.Status.Underruns);
        rig.Time.Advance(TimeSpan.FromSeconds(0.2));
        Assert.Equal(1, rig.Controller.Status.Underruns);
    }

    [Fact]
    public async Task After_the_host_died_the_watchdog_switches_off_and_stops_within_one_and_a_half_seconds()
    {
        await using var rig = new SimulatorRig();
        rig.Download(ExamplePrograms.Watchdog).Do("XQ#WDOG,1", "hb=20", "VMAB", "VS 20000", "VP 100000,0", "SB1", "BGS", "hb=20");
        var death = rig.Controller.Status.Sample;
        rig.Controller.DropConnections();

        rig.Time.Advance(TimeSpan.FromSeconds(4));

        var last = rig.Controller.Record.Snapshot()[^1];
        Assert.True(last.A is > 10000 and < 30000, "it was moving and did not run to its end");
        Assert.Equal(0, last.Outputs);
        Assert.InRange(last.Sample - death, 1000, 1500);
        Assert.True(rig.Controller.Status.IsIdle);
    }

    [Fact]
    public async Task Endless_threads_do_not_run_away_when_nobody_is_connected()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#A\nJP#A").Do("XQ");
        var before = rig.Controller.Status.Sample;

        rig.Time.Advance(TimeSpan.FromSeconds(1));

        Assert.InRange(rig.Controller.Status.Sample - before, 900, 1100);
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(25.0)]
    public async Task Real_time_follows_the_wall(double speed)
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = speed, Time = time });
        using var connection = controller.OpenConnection();
        Assert.Equal(":::", SimulatorRig.Exchange(connection, "SPA=10000;PRA=5000;BGA\r"));

        time.Advance(TimeSpan.FromSeconds(0.3 / speed));
        Assert.InRange(controller.Record.Snapshot()[^1].A, 2750, 2850);
        time.Advance(TimeSpan.FromSeconds(0.7 / speed));

        Assert.Equal(1000, controller.Status.Sample);
        Assert.Equal(5000, controller.Record.Snapshot()[^1].A);
        Assert.Throws<InvalidOperationException>(() => controller.Advance(TimeSpan.FromSeconds(1)));
    }

    [Fact]
    public async Task The_same_session_gives_the_same_record()
    {
        await using var first = new SimulatorRig();
        await using var second = new SimulatorRig();

        first.Run(ExamplePrograms.Draw);
        second.Run(ExamplePrograms.Draw);

        Assert.Equal(first.Controller.Record.Snapshot(), second.Controller.Record.Snapshot());
    }

    [Fact]
    public async Task Idle_is_awaited_and_a_dry_sequence_is_told_apart()
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(30));
        await using var rig = new SimulatorRig();
        Assert.True(await rig.Controller.WaitUntilIdleAsync(limit.Token));
        rig.Do("VMAB", "VP 2000,0", "BGS");
        var waiting = rig.Controller.WaitUntilIdleAsync(limit.Token);
        Assert.False(waiting.IsCompleted);

        rig.Time.Advance(TimeSpan.FromSeconds(3));

        Assert.False(await waiting);
    }
}
