namespace Engraver.Simulator.Tests;

/// <summary>The controller's own time for a command, before its prompt (docs/simulator-fidelity.md, "Time").</summary>
public class DecodeTests
{
    private const double LinkMilliseconds = 1.6;

    private static readonly SimulatorOptions s_slow = new() { DecodeTime = TimeSpan.FromMilliseconds(5) };

    [Theory]
    [InlineData("x=1", 1)]
    [InlineData("", 1)]
    [InlineData("nosuch", 1)]
    [InlineData("x=1;x=2;x=3", 3)]
    public async Task In_virtual_time_each_command_of_a_line_takes_its_time(string line, int commands)
    {
        await using var rig = new SimulatorRig(s_slow);

        for (var i = 0; i < 100; i++) Assert.Equal(commands, rig.Ask(line).Length);

        Assert.Equal(100 * commands * (5 + LinkMilliseconds), rig.Controller.Status.Sample, 1.0);
    }

    [Fact]
    public async Task On_the_serial_port_it_adds_to_the_time_of_the_bytes()
    {
        await using var rig = new SimulatorRig(s_slow);
        await using var serial = rig.Controller.OpenSerialConnection(19200);
        SimulatorRig.Exchange(serial, "EO 0\r");
        var before = rig.Controller.Status.Sample;

        for (var i = 0; i < 100; i++) Assert.Equal(" 1.0000\r\n:", SimulatorRig.Exchange(serial, "MG 1\r"));

        Assert.Equal(100 * (5 + (15 * 10_000.0 / 19200)), rig.Controller.Status.Sample - before, 1.0);
    }

    [Fact]
    public async Task A_host_with_the_clock_pays_it_at_speed_1_too()
    {
        await using var controller = new SimulatedController(s_slow with { Time = new StoppedTimeProvider() });
        using var connection = controller.OpenConnection();
        using var clock = controller.JoinClock();
        var before = clock.GetTimestamp();

        for (var i = 0; i < 100; i++) Assert.Equal(":", SimulatorRig.Exchange(connection, "x=1\r"));

        Assert.Equal(100 * (5 + LinkMilliseconds), clock.GetElapsedTime(before).TotalMilliseconds);
    }

    [Theory]
    [InlineData(1.0, false)]
    [InlineData(1.0, true)]
    [InlineData(2.5, false)]
    public async Task In_real_time_a_command_is_executed_and_answered_after_it(double speed, bool serial)
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(s_slow with { Speed = speed, Time = time });
        using var connection = serial ? controller.OpenSerialConnection(19200) : controller.OpenConnection();
        SimulatorRig.Exchange(connection, "EO 0\r");
        time.Advance(TimeSpan.FromSeconds(1));
        SimulatorRig.ReadAvailable(connection);

        Assert.Equal("", SimulatorRig.Exchange(connection, "SB 1;CB 1;nosuch\r"));
        Assert.Equal(("", 0), After(4.9));
        Assert.Equal((":", 1), After(0.2));
        Assert.Equal(("", 1), After(4.7));
        Assert.Equal((":", 0), After(0.3));
        Assert.Equal(("?", 0), After(5.0));

        (string Replies, byte Outputs) After(double milliseconds)
        {
            time.Advance(TimeSpan.FromMilliseconds(milliseconds / speed));
            return (SimulatorRig.ReadAvailable(connection), controller.Status.Outputs);
        }
    }

    /// <summary>The timer is later than the end of every decode time; this does not add up.</summary>
    [Fact]
    public async Task In_real_time_many_commands_at_once_take_the_sum_of_their_times()
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { DecodeTime = TimeSpan.FromMilliseconds(0.3), Time = time });
        using var connection = controller.OpenConnection();

        Assert.Equal("", SimulatorRig.Exchange(connection, string.Concat(Enumerable.Repeat("x=1\r", 1000))));
        time.Advance(TimeSpan.FromMilliseconds(150));
        Assert.Equal(500, SimulatorRig.ReadAvailable(connection).Length, 4.0);
        time.Advance(TimeSpan.FromMilliseconds(148));
        Assert.InRange(SimulatorRig.ReadAvailable(connection).Length, 480, 497);
        time.Advance(TimeSpan.FromMilliseconds(4));
        Assert.NotEqual("", SimulatorRig.ReadAvailable(connection));
        Assert.Equal(302, controller.Status.Sample);
    }

    [Fact]
    public async Task In_real_time_a_host_that_waits_for_each_prompt_never_gets_one_early()
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { DecodeTime = TimeSpan.FromMilliseconds(2.5), Time = time });
        using var connection = controller.OpenConnection();

        for (var i = 0; i < 40; i++)
        {
            Assert.Equal("", SimulatorRig.Exchange(connection, "x=1\r"));
            time.Advance(TimeSpan.FromMilliseconds(2.4));
            Assert.Equal("", SimulatorRig.ReadAvailable(connection));
            time.Advance(TimeSpan.FromMilliseconds(1.1));
            Assert.Equal(":", SimulatorRig.ReadAvailable(connection));
        }
    }

    [Fact]
    public async Task In_real_time_two_links_take_turns()
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(s_slow with { Time = time });
        using var busy = controller.OpenConnection();
        using var other = controller.OpenConnection();

        SimulatorRig.Exchange(busy, "x=1;x=2;x=3;x=4\r");
        SimulatorRig.Exchange(other, "x=9\r");
        time.Advance(TimeSpan.FromMilliseconds(11));
        Assert.Equal((":", ":"), (SimulatorRig.ReadAvailable(busy), SimulatorRig.ReadAvailable(other)));
        time.Advance(TimeSpan.FromMilliseconds(20));
        Assert.Equal((":::", ""), (SimulatorRig.ReadAvailable(busy), SimulatorRig.ReadAvailable(other)));
    }

    [Fact]
    public async Task In_real_time_a_link_that_closes_takes_its_waiting_commands_along()
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(s_slow with { Time = time });
        using (var connection = controller.OpenConnection()) SimulatorRig.Exchange(connection, "SB 1;SB 2\r");

        time.Advance(TimeSpan.FromSeconds(1));

        Assert.Equal((0, 0), (controller.Status.Outputs, controller.Status.OpenHandles));
    }
}
