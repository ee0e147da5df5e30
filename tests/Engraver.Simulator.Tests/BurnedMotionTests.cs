namespace Engraver.Simulator.Tests;

/// <summary>Parameters burned by the owner before the simulation starts (simulate --machine).</summary>
public class BurnedMotionTests
{
    [Fact]
    public async Task Speeds_of_the_owner_stand_at_power_up_and_come_back_with_a_reset()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Burned = new BurnedMotion(20000, 102400, [50000, 40000]) });
        Assert.Equal(" 50000, 40000, 25000, 25000\r\n:", rig.Ask("SP ?,?,?,?"));
        rig.Do("SP 2,2", "VS 2,2", "AC 1024", "VD 1024");

        rig.Ask("RS");

        await using var after = rig.Controller.OpenConnection();
        Assert.Equal(" 50000.0000 40000.0000 20000.0000 20000.0000\r\n:", SimulatorRig.Exchange(after, "MG _SPA,_SPB,_VSS,_VST\r"));
        Assert.Equal(" 102400.0000 102400.0000 102400.0000\r\n:", SimulatorRig.Exchange(after, "MG _ACA,_VDS,_DCN\r"));
    }
}
