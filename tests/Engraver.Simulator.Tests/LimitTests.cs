namespace Engraver.Simulator.Tests;

/// <summary>Limit inputs and their polarity (galil-dmc.md C.1).</summary>
public class LimitTests
{
    private const string Counter = "#AUTO\nnlim=0\n#IDLE\nWT 10\nJP#IDLE\nEN\n#LIMSWI\nnlim=nlim+1\nRE1\n";

    [Theory]
    [InlineData("CN -1", false, 1)]
    [InlineData("CN -1", true, 0)]
    [InlineData("CN 1", false, 0)]
    [InlineData("CN 1", true, 1)]
    public async Task Polarity_decides_what_a_grounded_limit_input_means(string polarity, bool grounded, int allowed)
    {
        await using var rig = new SimulatorRig();
        rig.Controller.SetLimitSwitch(0, forward: true, active: grounded);

        rig.Do(polarity, "PRA=100");

        Assert.Equal(allowed, rig.Value("_LFA"));
        Assert.Equal(allowed == 1 ? ":" : "?", rig.Ask("BGA"));
    }

    [Fact]
    public async Task Normally_closed_switches_suit_CN_1()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Switches = [new AxisSwitches(0) { ForwardLimitAt = 1000, AreNormallyClosed = true }] });
        rig.Controller.SetLimitSwitch(0, forward: false, active: true);

        rig.Do("CN 1", "PRA=5000", "BGA").RunToIdle();

        Assert.Equal(2, rig.Value("_SCA"));
        Assert.InRange(rig.Value("_RPA"), 1000, 3000);
        Assert.Equal(22, rig.Refusal("BGA"));
        rig.Do("PRA=-3000", "BGA").RunToIdle();
        Assert.Equal(1, rig.Value("_SCA"));
    }

    [Theory]
    [InlineData(true, 1)]
    [InlineData(false, 0)]
    public async Task Flipping_CN_in_a_jog_stops_it_and_runs_LIMSWI_when_thread_0_runs(bool threadZero, int handled)
    {
        await using var rig = new SimulatorRig();
        rig.Download(Counter).Do("nlim=0", "JGA=5000", "BGA");
        if (threadZero) rig.Do("XQ#AUTO");
        rig.Pass(200);

        rig.Do("CN 1").Pass(200);

        Assert.Equal((handled, 0, 2), (rig.Value("nlim"), rig.Value("_BGA"), rig.Value("_SCA")));
    }

    [Fact]
    public async Task A_handler_that_never_returns_fills_the_stack_and_ends_in_code_12()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#IDLE\nWT 10\nJP#IDLE\nEN\n#LIMSWI\nnlim=nlim+1\nJP#IDLE").Do("nlim=0", "XQ#IDLE");

        for (var i = 0; i < 17; i++) rig.Do("JGA=5000", "BGA").Pass(20).Do("CN 1").Pass(50).Do("CN -1");

        Assert.Equal((16, 12, 0), (rig.Value("nlim"), rig.Value("_TC"), rig.Value("_NO")));
    }

    [Fact]
    public async Task With_OE_2_a_limit_switches_the_motor_off_instead_of_braking()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Switches = [new AxisSwitches(0) { ForwardLimitAt = 1000 }] });

        rig.Do("OEA=2", "JGA=20000", "BGA").RunToIdle();

        Assert.Equal((1, 2), (rig.Value("_MOA"), rig.Value("_SCA")));
        Assert.InRange(rig.Value("_RPA"), 1000, 1040); // detected one sample later, 20 counts each
    }

    [Fact]
    public async Task A_limit_of_one_axis_brakes_the_whole_sequence()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Switches = [new AxisSwitches(1) { ForwardLimitAt = 2000 }] });

        rig.Do("VMAB", "VS 10000", "VP 30000,30000", "VE", "BGS").RunToIdle();

        Assert.Equal((0, 2, 2), (rig.Value("_BGS"), rig.Value("_SCA"), rig.Value("_SCB")));
        Assert.Equal(rig.Value("_RPA"), rig.Value("_RPB"));
    }
}
