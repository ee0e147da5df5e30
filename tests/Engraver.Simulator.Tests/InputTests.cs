namespace Engraver.Simulator.Tests;

/// <summary>Input interrupt, latches, selective abort (galil-dmc.md C, D).</summary>
public class InputTests
{
    private const string Interrupted = "#AUTO\nn=0\nII 2,3\n#IDLE\nWT 10\nJP#IDLE\nEN\n#ININT\nn=n+1\nAI 2\nRI1\n";

    [Fact]
    public async Task A_watched_input_runs_ININT_and_RI_arms_it_again()
    {
        await using var rig = new SimulatorRig();
        rig.Download(Interrupted).Do("XQ#AUTO").Pass(50);
        Assert.Equal(0x89, int.Parse(rig.Ask("TB")[..^3], System.Globalization.CultureInfo.InvariantCulture));

        rig.Controller.SetInput(4, false);
        Assert.Equal(0, rig.Pass(50).Value("n"));
        rig.Controller.SetInput(2, false);
        Assert.Equal(1, rig.Pass(50).Value("n"));
        Assert.Equal(0x85, int.Parse(rig.Ask("TB")[..^3], System.Globalization.CultureInfo.InvariantCulture));
        rig.Controller.SetInput(2, true);
        rig.Pass(50);
        rig.Controller.SetInput(2, false);
        Assert.Equal(2, rig.Pass(50).Value("n"));
    }

    [Theory]
    [InlineData("CN ,,-1", false)]
    [InlineData("CN ,,1", true)]
    public async Task A_latch_keeps_the_position_at_its_edge(string polarity, bool level)
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.Zero });
        rig.Controller.SetInput(1, !level);
        rig.Do(polarity, "ALA", "JGA=10000", "BGA").Pass(500);
        Assert.Equal(1, rig.Value("_ALA"));
        var here = rig.Value("_TPA");

        rig.Controller.SetInput(1, level);
        rig.Pass(100);

        Assert.Equal((0, here), (rig.Value("_ALA"), rig.Value("_RLA")));
        Assert.Equal($" {here}\r\n:", rig.Ask("RLA"));
    }

    [Fact]
    public async Task ALT_latches_on_the_index()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Switches = [new AxisSwitches(1) { IndexAt = 1234 }] });

        rig.Do("ALTB", "PRB=3000", "BGB").RunToIdle();

        Assert.Equal(1234, rig.Value("_RLB"));
    }

    [Fact]
    public async Task Selective_abort_stops_its_axis_at_once_when_CN_says_so()
    {
        await using var rig = new SimulatorRig();
        rig.Do("CN ,,,1", "JGA=10000;JGB=10000", "BGAB").Pass(100);

        rig.Controller.SetInput(6, false);

        Assert.Equal((1, 0, 11), (rig.Value("_BGA"), rig.Value("_BGB"), rig.Value("_SCB")));
    }

    [Fact]
    public async Task A_message_to_a_lost_handle_runs_TCPERR()
    {
        await using var rig = new SimulatorRig();
        var second = rig.Controller.OpenConnection();
        SimulatorRig.Exchange(second, "CFI\r");
        rig.Download("#AUTO\nlost=0\n#LOOP\nWT 20\nMG \"ALIVE\"\nJP#LOOP\nEN\n#TCPERR\nlost=_TC\nRE1\n").Do("XQ").Pass(100);

        await second.DisposeAsync();
        rig.Pass(200);

        Assert.Equal(123, rig.Value("lost"));
    }
}
