namespace Engraver.Simulator.Tests;

/// <summary>RA, RD, RC: recording into arrays (galil-dmc.md E, Array; A.8 codes 80 to 82).</summary>
public class CaptureTests
{
    [Fact]
    public async Task Every_source_fills_its_array_at_its_rate()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.Zero });
        rig.Do("DM p[10],t[10],o[10]", "RA p[],t[],o[]", "RD _RPA,TIME,_OP", "JGA=10000", "BGA").Pass(200);
        var start = (rig.Value("TIME"), rig.Value("_RPA"));

        rig.Do("SB1", "RC 2,5");
        Assert.Equal((1, 0), (rig.Value("_RC"), rig.Value("_RD")));
        rig.Pass(30);

        Assert.Equal(start.Item1 + 4, rig.Value("t[0]"));
        Assert.Equal(start.Item1 + 20, rig.Value("t[4]"));
        Assert.Equal((start.Item2 + 40, start.Item2 + 200), (rig.Value("p[0]"), rig.Value("p[4]")));
        Assert.Equal((1, 0, 0), (rig.Value("o[4]"), rig.Value("p[5]"), rig.Value("_RC")));
        Assert.Equal((5, " 0\r\n:"), (rig.Value("_RD"), rig.Ask("RC ?")));
    }

    [Fact]
    public async Task Without_a_count_the_shortest_array_decides()
    {
        await using var rig = new SimulatorRig();
        rig.Do("DM p[10],q[3]", "RA p[],q[]", "RD TIME,TIME", "RC 1").Pass(100);

        Assert.Equal((3, 0), (rig.Value("_RD"), rig.Value("p[3]")));
        Assert.NotEqual(0, rig.Value("q[2]"));
    }

    [Fact]
    public async Task A_negative_count_goes_round_until_RC_0()
    {
        await using var rig = new SimulatorRig();
        rig.Do("DM p[4]", "RA p[]", "RD TIME", "RC 1,-4").Pass(100);
        Assert.Equal(1, rig.Value("_RC"));

        rig.Do("RC 0");
        var last = rig.Value("p[0]");

        Assert.Equal((0, last), (rig.Value("_RC"), rig.Pass(50).Value("p[0]")));
        Assert.InRange(last, 90, 130);
    }

    [Fact]
    public async Task At_max_a_recording_is_an_event_that_a_silent_host_gets()
    {
        await using var rig = new SimulatorRig();
        rig.Do("DM p[100]", "RA p[]", "RD TIME", "RC 8");

        rig.Time.Advance(TimeSpan.FromMilliseconds(20));

        Assert.Equal(0, rig.Value("_RC"));
        Assert.InRange(rig.Controller.Status.Sample, 25600, 25700);
    }

    [Theory]
    [InlineData("RC 1", 81)]
    [InlineData("RA nix[]", 82)]
    [InlineData("DM p[4];RA p", 55)]
    [InlineData("DM p[4],q[4];RA p[],q[];RD _TPA;RC 1", 81)]
    [InlineData("RD _QQA", 81)]
    [InlineData("RD _AFA", 132)]
    [InlineData("RD _TPE", 58)]
    [InlineData("RD TIME,_TP", 58)]
    [InlineData("DM p[4];RA p[];RD _TPA;RC 1,5", 84)]
    [InlineData("DM p[4];RA p[];RD _TPA;RC 8;RC 8", 80)]
    [InlineData("DM p[4];RA p[];RD _TPA;RC 8;RA p[]", 80)]
    [InlineData("DM p[4];RA p[];RD _TPA;RC 9", 6)]
    [InlineData("DM eightchr[4];RA eightchr[]", 82)]
    public async Task What_cannot_be_recorded_is_told_by_its_code(string line, int code)
    {
        await using var rig = new SimulatorRig();

        var reply = rig.Ask(line);

        Assert.Equal(new string(':', reply.Length - 1) + "?", reply);
        Assert.Equal($" {code}\r\n:", rig.Ask("TC"));
    }
}
