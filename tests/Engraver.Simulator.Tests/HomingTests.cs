namespace Engraver.Simulator.Tests;

/// <summary>HM, FE, FI (galil-dmc.md C.2).</summary>
public class HomingTests
{
    private static SimulatorOptions Home => new() { Switches = [new AxisSwitches(0) { HomeAt = -1000, IndexAt = -700, IndexPeriod = 2000 }] };

    [Theory]
    [InlineData("CN ,-1", false, 1)]
    [InlineData("CN ,-1", true, 0)]
    [InlineData("CN ,1", false, 0)]
    [InlineData("CN ,1", true, 1)]
    public async Task The_home_input_reads_as_its_polarity_says(string polarity, bool grounded, int level)
    {
        await using var rig = new SimulatorRig();
        rig.Controller.SetHomeSwitch(0, grounded);

        Assert.Equal(level, rig.Do(polarity).Value("_HMA"));
    }

    [Fact]
    public async Task FE_stops_behind_the_edge_with_code_9()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Switches = [new AxisSwitches(0) { HomeAt = 1000 }] });
        rig.Do("CN ,1", "SPA=4000", "FEA", "BGA"); // open with CN 1 reads 0: forward

        rig.RunToIdle();

        Assert.Equal(9, rig.Value("_SCA"));
        Assert.InRange(rig.Value("_RPA"), 1031, 1040);
    }

    [Fact]
    public async Task FI_goes_back_to_the_index_and_calls_it_zero()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Switches = [new AxisSwitches(0) { IndexAt = 1500 }] });
        rig.Do("JGA=4000", "FIA", "BGA");

        rig.RunToIdle();

        Assert.Equal((10, 0, 0), (rig.Value("_SCA"), rig.Value("_RPA"), rig.Value("_TPA")));
        Assert.InRange(rig.Controller.Record.Snapshot().Max(s => s.A), 1531, 1540);
        rig.Do("PRA=-1500", "BGA").RunToIdle().Do("FIA", "BGA").RunToIdle();
        Assert.Equal(0, rig.Value("_RPA"));
    }

    [Fact]
    public async Task HM_of_a_servo_finds_the_edge_slowly_and_ends_on_the_index()
    {
        await using var rig = new SimulatorRig(Home);
        rig.Do("CN ,1", "SPA=8000", "HMA"); // the switch is pressed at the start and reads 1: backward

        rig.Do("BGA").RunToIdle();

        Assert.Equal((10, 0, 1), (rig.Value("_SCA"), rig.Value("_RPA"), rig.Value("_HMA")));
        var rows = rig.Controller.Record.Snapshot();
        Assert.InRange(rows.Min(s => s.A), -1140, -1120);
        rig.Do("PRA=700", "BGA").RunToIdle();
        Assert.Equal(700, rig.Value("_TPA"));
    }

    [Fact]
    public async Task HM_of_a_stepper_ends_at_the_edge_without_zeroing()
    {
        await using var rig = new SimulatorRig(Home);
        rig.Do("MOA", "MTA=2", "SHA", "CN ,1", "SPA=8000", "HMA", "BGA").RunToIdle();

        Assert.Equal(10, rig.Value("_SCA"));
        Assert.Equal(-1000, rig.Value("_RPA"), 1.0);
    }

    [Fact]
    public async Task Homing_is_not_possible_in_motion_and_a_stop_ends_it()
    {
        await using var rig = new SimulatorRig();
        rig.Do("JGA=1000", "BGA");

        Assert.Equal(7, rig.Refusal("HMA"));
        rig.Do("STA").RunToIdle().Do("HMA", "BGA").Pass(100).Do("STA").RunToIdle();
        Assert.Equal(4, rig.Value("_SCA"));
    }
}
