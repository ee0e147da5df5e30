namespace Engraver.Simulator.Tests;

/// <summary>IP, PT, DE, ES, IT, VT, TM and the variable axes (galil-dmc.md B.1, C, E).</summary>
public class AxisModeTests
{
    [Fact]
    public async Task IP_moves_at_rest_extends_a_move_and_jumps_in_a_jog()
    {
        await using var rig = new SimulatorRig();
        rig.Do("IPA=500").RunToIdle();
        Assert.Equal(500, rig.Value("_RPA"));

        rig.Do("PRA=20000", "BGA").Pass(100);
        Assert.Equal(16, rig.Refusal("IPA=-10"));
        rig.Do("IPA=1000").RunToIdle();
        Assert.Equal(21500, rig.Value("_RPA"));

        rig.Do("JGA=0", "BGA").Pass(10).Do("IPA=-300").Pass(1);
        Assert.Equal(21200, rig.Value("_RPA"));
    }

    [Fact]
    public async Task Under_PT_each_PA_moves_at_once_and_may_turn_round()
    {
        await using var rig = new SimulatorRig();
        rig.Do("PTA=1", "PAA=20000").Pass(300);
        Assert.Equal(1, rig.Value("_BGA"));

        rig.Do("PAA=-100").RunToIdle();

        Assert.Equal(-100, rig.Value("_RPA"));
        Assert.InRange(rig.Controller.Record.Snapshot().Max(s => s.A), 4000, 12000);
        rig.Do("STA", "PAA=50");
        Assert.Equal((0, 0), (rig.Value("_BGA"), rig.Value("_PTA")));
    }

    [Fact]
    public async Task DE_sets_the_second_encoder_of_a_servo()
    {
        await using var rig = new SimulatorRig();

        Assert.Equal((77, 0), (rig.Do("DEA=77").Value("_TDA"), rig.Value("_TPA")));
    }

    [Theory]
    [InlineData("ES 2,1", 2000, 500)]
    [InlineData("ES 1,4", 1000, 2000)]
    public async Task ES_scales_the_axis_with_the_coarser_resolution(string scale, int a, int b)
    {
        await using var rig = new SimulatorRig();

        rig.Do("VMAB", scale, "VP 1000,500", "VE", "BGS").RunToIdle();

        Assert.Equal((a, b), (rig.Value("_RPA"), rig.Value("_RPB")));
    }

    [Fact]
    public async Task IT_and_VT_make_moves_longer_and_end_at_the_same_place()
    {
        await using var rig = new SimulatorRig();
        var plain = rig.Run("PRA=5000\nBGA\nAMA\nEN");

        var smooth = rig.Do("ITA=0.1").Run("PRA=5000\nBGA\nAMA\nEN");
        Assert.True(smooth > plain + 0.02, $"{smooth} against {plain} s");
        Assert.Equal(10000, rig.Value("_RPA"));

        var sharp = rig.Run("VMAB\nVP 3000,4000\nVE\nBGS\nAMS\nEN");
        var round = rig.Do("VT 0.1").Run("VMAB\nVP 3000,4000\nVE\nBGS\nAMS\nEN");
        Assert.True(round > sharp + 0.02, $"{round} against {sharp} s");
        Assert.Equal((16000, 8000, 101), (rig.Value("_RPA"), rig.Value("_RPB"), rig.Value("_SCA")));
    }

    [Fact]
    public async Task TM_scales_steps_TIME_and_speeds_on_segments_but_not_speeds()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.Zero });
        rig.Do("TM 250", "SPA=1006", "ACA=20000");
        Assert.Equal((1000, 16384, 250), (rig.Value("_SPA"), rig.Value("_ACA"), rig.Value("_TM")));

        var time = rig.Value("TIME");
        Assert.Equal(400, rig.Pass(100).Value("TIME") - time);

        rig.Do("VMAB", "VS 100000", "VA 1024000", "VP 100000,0<25000", "VE", "BGS").Pass(300);
        Assert.Equal(100000, rig.Value("_VMS"));
        Assert.Equal(7, rig.Refusal("TM 1000"));
    }

    [Fact]
    public async Task Variable_axes_stand_for_letters()
    {
        await using var rig = new SimulatorRig();

        rig.Do("~a=2", "PR~a=1000", "BG~a").RunToIdle();

        Assert.Equal((1000, 1000, 2), (rig.Value("_RPC"), rig.Value("_RP~a"), rig.Value("~a")));
        rig.Do("~b=8", "VMAB", "VP 100,0", "VE", "BG~b").RunToIdle();
        Assert.Equal(100, rig.Value("_RPA"));
        Assert.Equal(6, rig.Refusal("~a=12"));
    }

    [Fact]
    public async Task LI_takes_a_single_axis()
    {
        await using var rig = new SimulatorRig();

        rig.Do("LMAB", "LIB=700<5000", "LE", "BGS").RunToIdle();

        Assert.Equal((0, 700), (rig.Value("_RPA"), rig.Value("_RPB")));
    }
}
