using static System.FormattableString;

namespace Engraver.Simulator.Tests;

/// <summary>Queries about axes, and the abort input (galil-dmc.md A.3, A.10, D, I.12).</summary>
public class ReportTests
{
    [Fact]
    public async Task Each_question_answers_for_the_axes_it_names()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.Zero, ServoLag = TimeSpan.FromMilliseconds(10) });
        rig.Do("DPA=200;DPB=-10;DPD=-110");

        Assert.Equal(" 200, -10, 0, -110\r\n:", rig.Ask("TP"));
        Assert.Equal(" 200, -110\r\n:", rig.Ask("RPAD"));
        Assert.Equal(" 0, 0, 0, 0\r\n:", rig.Ask("TD"));
        Assert.Equal(" 0, 0, 0, 0\r\n:", rig.Ask("TE"));
        Assert.Equal(" 0, 0, 0, 0\r\n:", rig.Ask("TV"));
        Assert.Equal(" 0.0000, 0.0000, 0.0000, 0.0000\r\n:", rig.Ask("TT"));

        rig.Do("JG 20000,-10000", "BGAB").Pass(500);
        Assert.Equal(" 20000, -10000, 0, 0\r\n:", rig.Ask("TV"));
        Assert.Equal(Invariant($" {rig.Value("_RPA-_TPA")}, {rig.Value("_RPB-_TPB")}, 0, 0\r\n:"), rig.Ask("TE"));
        Assert.Equal(200, rig.Value("_TEA"), 15.0); // speed times lag
        Assert.Equal((20000, -10000), (rig.Value("_TVA"), rig.Value("_TVB")));
        Assert.Equal((0, 0), (rig.Value("_TTA"), rig.Value("_TDB")));
    }

    [Fact]
    public async Task A_plane_is_no_axis_to_be_asked_for()
    {
        await using var rig = new SimulatorRig();

        Assert.Equal("?", rig.Ask("TPS"));
        Assert.Equal("?", rig.Ask("TVS"));
    }

    [Theory]
    [InlineData("CN ,,,,0", false)]
    [InlineData("CN ,,,,1", true)]
    public async Task The_abort_input_stops_all_motion_without_a_ramp_and_programs_unless_CN_spares_them(string setting, bool programsGoOn)
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.Zero });
        rig.Download("#LOOP\nWT 100\nJP#LOOP\nEN\n").Do("XQ#LOOP", setting, "OEB=1", "JG 20000,10000,5000", "BGABC").Pass(500);
        var here = rig.Value("_RPA");
        Assert.Equal(1, rig.Value("_AB"));

        rig.Controller.SetAbortInput(true);
        rig.Pass(100);

        Assert.Equal((0.0, here), (rig.Value("_AB"), rig.Value("_RPA")));
        Assert.Equal(" 6, 6, 6, 1\r\n:", rig.Ask("SC"));
        Assert.Equal((0, 1, 0), (rig.Value("_MOA"), rig.Value("_MOB"), rig.Value("_MOC")));
        Assert.Equal(programsGoOn ? 1 : 0, rig.Value("_NO"));
        rig.Controller.SetAbortInput(true);
        rig.Controller.SetAbortInput(false);
        Assert.Equal(1, rig.Value("_AB"));
    }
}
