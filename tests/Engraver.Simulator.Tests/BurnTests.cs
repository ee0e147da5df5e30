namespace Engraver.Simulator.Tests;

/// <summary>BN, BV and the state that RS restores (galil-dmc.md A.6).</summary>
public class BurnTests
{
    [Fact]
    public async Task RS_brings_back_what_BN_burned_and_the_factory_settings_of_the_rest()
    {
        await using var rig = new SimulatorRig();
        rig.Do("SPA=4000", "VS 6000", "CN 1", "SB2", "KPA=9", "VF 8.2", "CW 1", "GAB=A", "GRB=2", "BN");

        using var again = Reset(rig.Do("SPA=100", "ACA=102400", "VS 800", "CN -1", "CB2", "KPA=1", "VF 5.0", "CW 2", "GRB=3", "VR 0.5"));

        Assert.Equal(" 4000.00 256000.00 6000.00 1.00\r\n:", SimulatorRig.Exchange(again, "MG _SPA,_ACA,_VSS,_CN0\r"));
        Assert.Equal(" 1.00 9.00 1.00 2.00 1.00\r\n:", SimulatorRig.Exchange(again, "MG @OUT[2],_KPA,_CW,_GRB,_VRS\r"));
    }

    [Fact]
    public async Task RS_brings_back_the_variables_arrays_and_cam_table_of_BV_and_forgets_later_ones()
    {
        await using var rig = new SimulatorRig();
        rig.Do("keep=5", "DM p[2]", "p[1]=7", "EAA", "EMB=300", "ET[1]=,40", "BV");

        using var again = Reset(rig.Do("keep=6", "later=1", "p[1]=8", "ET[1]=,50"));

        Assert.Equal(" 5.0000 7.0000 300.0000\r\n:", SimulatorRig.Exchange(again, "MG keep,p[1],_EMB\r"));
        Assert.Equal(" 40\r\n:", SimulatorRig.Exchange(again, "ET[1]=,?\r"));
        Assert.Equal("?", SimulatorRig.Exchange(again, "MG later\r"));
    }

    [Fact]
    public async Task Positions_targets_and_the_routing_of_messages_are_not_burned()
    {
        await using var rig = new SimulatorRig();
        rig.Do("DPA=500", "PRB=77", "CF A", "BN");

        using var again = Reset(rig);

        Assert.Equal(" 0.0000 0.0000 83.0000\r\n:", SimulatorRig.Exchange(again, "MG _RPA,_PRB,_CF\r"));
    }

    [Fact]
    public async Task BN_while_a_program_runs_is_refused()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#A\nWT 100\nJP#A").Do("XQ");

        Assert.Equal(17, rig.Refusal("BN"));
    }

    private static Stream Reset(SimulatorRig rig)
    {
        Assert.Equal(":", rig.Ask("RS"));
        return rig.Controller.OpenConnection();
    }
}
