namespace Engraver.Simulator.Tests.Motion.Following;

/// <summary>GA, GR, GM (galil-dmc.md B.6).</summary>
public class GearTests
{
    [Theory]
    [InlineData("GA ,,S", "GR ,,0.5")]
    [InlineData("GAC=S", "GRC=0.5")]
    public async Task A_dispenser_follows_the_path_always_forwards(string master, string ratio)
    {
        await using var rig = new SimulatorRig();

        rig.Do(master, ratio, "VMAB", "VP 1000,0", "VP 0,0", "VE", "BGS").RunToIdle();

        Assert.Equal((0, 1000), (rig.Value("_RPA"), rig.Value("_RPC")));
    }

    [Fact]
    public async Task A_dispenser_goes_on_forwards_in_the_next_sequence()
    {
        await using var rig = new SimulatorRig();
        rig.Do("GAC=S", "GRC=0.5", "VMAB", "VP 1000,0", "VE", "BGS").RunToIdle();

        rig.Do("CSS", "VP -600,0", "VE", "BGS").RunToIdle();
        Assert.Equal(800, rig.Value("_RPC"));

        rig.Do("VMAB", "VP 200,0", "VE", "BGS").RunToIdle();
        Assert.Equal(900, rig.Value("_RPC"));
    }

    [Fact]
    public async Task An_axis_follows_another_with_its_sign()
    {
        await using var rig = new SimulatorRig();

        rig.Do("GAB=A", "GRB=-2", "PRA=500", "BGA").RunToIdle();

        Assert.Equal(-1000, rig.Value("_RPB"));
    }

    [Fact]
    public async Task A_follower_in_front_of_its_master_arrives_too_and_so_does_the_follower_of_a_follower()
    {
        await using var rig = new SimulatorRig();

        rig.Do("GAB=C", "GRB=1", "GAA=B", "GRA=3", "PRC=500", "BGC").RunToIdle();

        Assert.Equal((1500, 500), (rig.Value("_RPA"), rig.Value("_RPB")));
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(1, -2)]
    public async Task ST_ends_gearing_unless_GM_holds_it(int gantry, int ratio)
    {
        await using var rig = new SimulatorRig();

        rig.Do("GAB=A", $"GMB={gantry}", "GRB=-2", "STB");

        Assert.Equal(ratio, rig.Value("_GRB"));
    }

    [Fact]
    public async Task An_axis_is_not_its_own_master()
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(46, rig.Refusal("GAB=B"));
    }
}
