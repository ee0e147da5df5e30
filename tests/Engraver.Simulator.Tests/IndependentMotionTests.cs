namespace Engraver.Simulator.Tests;

/// <summary>galil-dmc.md C and A.7.</summary>
public class IndependentMotionTests
{
    [Fact]
    public async Task Relative_and_absolute_moves_end_at_their_targets_after_the_golden_time()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.Zero });
        rig.Do("SPA=10000;ACA=256000;DCA=256000", "PRA=5000", "BGA").RunToIdle();

        Assert.Equal((5000, 1), (rig.Value("_RPA"), rig.Value("_SCA")));
        Assert.InRange(rig.Controller.Status.Sample, 538, 542); // 5000/10000 + 10000/256000 s
        rig.Do("BGA").RunToIdle().Do("PAA=-3", "BGA").RunToIdle();
        Assert.Equal((-3, -3), (rig.Value("_RPA"), rig.Value("_PAA")));
    }

    [Fact]
    public async Task PA_reports_where_the_last_motion_stopped_until_the_next_one_stops()
    {
        await using var rig = new SimulatorRig();
        rig.Do("PAA=1000");

        Assert.Equal(" 0\r\n:", rig.Ask("PA ?"));
        Assert.Equal(1000, rig.Value("_PRA"));
    }

    [Fact]
    public async Task Refusals_of_begin_and_settings()
    {
        await using var rig = new SimulatorRig();
        rig.Do("PRA=100000", "BGA");

        Assert.Equal(
            (21, 7, 7, 13, 7),
            (rig.Refusal("BGA"), rig.Refusal("PAA=0"), rig.Refusal("DPA=0"), rig.Refusal("JGA=500"), rig.Refusal("DCA=102400")));
        rig.Do("SPA=50000", "ACA=512000").RunToIdle();
        rig.Do("FLA=100000", "PRA=1");
        Assert.Equal(22, rig.Refusal("BGA"));
        Assert.Equal(7, rig.Refusal("MTA=2"));
    }

    [Fact]
    public async Task Jog_follows_speed_changes_turns_round_and_stops_with_ST()
    {
        await using var rig = new SimulatorRig();
        rig.Do("JGA=10000", "BGA").Pass(500);
        Assert.Equal((10000, 10000), (rig.Value("_TVA"), rig.Value("_SPA")));

        rig.Do("JGA=-5000").Pass(500);
        Assert.Equal(-5000, rig.Value("_TVA"));
        rig.Do("STA").RunToIdle();
        Assert.Equal((4, 0), (rig.Value("_SCA"), rig.Value("_BGA")));
    }

    [Fact]
    public async Task Software_limit_stops_with_its_code()
    {
        await using var rig = new SimulatorRig();
        rig.Do("BLA=-2000", "JGA=-10000", "BGA").RunToIdle();

        Assert.Equal(3, rig.Value("_SCA"));
        Assert.InRange(rig.Value("_RPA"), -2240, -2195);
        Assert.Equal(22, rig.Refusal("BGA"));
        rig.Do("JGA=1000", "BGA", "ST").RunToIdle();
    }

    [Fact]
    public async Task Bare_ST_from_the_host_halts_programs_but_STS_and_ST_AB_do_not()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#A\nWT 10\nJP#A").Do("XQ", "PR 100000,100000", "BG AB", "STS", "ST AB").RunUntilStill();
        Assert.Equal(1, rig.Value("_NO"));

        rig.Do("ST");

        Assert.Equal(0, rig.Value("_NO"));
    }

    [Fact]
    public async Task Bare_ST_in_a_program_stops_motion_only()
    {
        await using var rig = new SimulatorRig();
        rig.Download("PRA=1000000;BGA\nWT 100\nST\nAMA\nn=1\nEN").Do("XQ").RunToIdle();

        Assert.Equal((1, 4), (rig.Value("n"), rig.Value("_SCA")));
    }

    [Fact]
    public async Task Abort_switches_motors_off_whose_OE_asks_for_it()
    {
        await using var rig = new SimulatorRig();
        rig.Do("OEA=1", "PR 5000,5000", "BGAB").Pass(100).Do("AB1");

        Assert.Equal((1, 0, 7, 7), (rig.Value("_MOA"), rig.Value("_MOB"), rig.Value("_SCA"), rig.Value("_SCB")));
        Assert.InRange(rig.Value("_RPA"), 1, 4999);
    }

    [Fact]
    public async Task Trippoints_of_distance_and_position_release_on_the_way()
    {
        await using var rig = new SimulatorRig();
        const string program = "PAA=10000;BGA\nAD 2000;d=_RPA\nAP 5000;p=_RPA\nMFA=7000;f=_RPA\nAMA;e=_RPA\nEN";

        rig.Run(program);

        Assert.InRange(rig.Value("d"), 2000, 2100);
        Assert.InRange(rig.Value("p"), 5000, 5100);
        Assert.InRange(rig.Value("f"), 7000, 7100);
        Assert.Equal(10000, rig.Value("e"));
    }

    [Fact]
    public async Task AI_waits_for_an_input()
    {
        await using var rig = new SimulatorRig();
        rig.Download("AI -3\nn=1\nEN").Do("n=0", "XQ").Pass(100);
        Assert.Equal((0, 2), (rig.Value("n"), rig.Value("_HX0")));

        rig.Controller.SetInput(3, false);
        rig.Pass(5);

        Assert.Equal((1, 0), (rig.Value("n"), rig.Value("@IN[3]")));
        Assert.Equal(" 251\r\n:", rig.Ask("TI"));
    }

    [Fact]
    public async Task AR_counts_from_the_AR_before_and_AD_from_the_beginning()
    {
        await using var rig = new SimulatorRig();

        rig.Run("PRA=20000\nBGA\nADA=5000\na=_RPA\nARA=6000\nb=_RPA\nARA=6000\nc=_RPA\nEN");

        Assert.InRange(rig.Value("a"), 5000, 5060);
        Assert.InRange(rig.Value("b"), 6000, 6060);
        Assert.InRange(rig.Value("c"), 12000, 12060);
    }
}
