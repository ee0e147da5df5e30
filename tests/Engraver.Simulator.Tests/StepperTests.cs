namespace Engraver.Simulator.Tests;

/// <summary>A stepper has no encoder in its loop: it counts the steps that it is sent, including those that its shaft did not make (galil-dmc.md C,
/// MT).</summary>
public class StepperTests
{
    [Fact]
    public async Task A_blocked_stepper_loses_the_steps_that_come_meanwhile_and_the_controller_does_not_see_it()
    {
        await using var rig = Jammed();

        Assert.Equal((7000, 7000, 0), (rig.Value("_RPA"), rig.Value("_TPA"), rig.Value("_TEA")));
        Assert.Equal((5000, 2000), (rig.Controller.MotorPlace(0), rig.Controller.PlaceOf(0, 4000)));
        Assert.Equal(5000, rig.Controller.Record[rig.Controller.Record.Count - 1].A);
    }

    [Fact]
    public async Task Freed_it_goes_on_displaced_by_what_it_has_lost_and_neither_SH_nor_an_error_limit_mends_that()
    {
        await using var rig = Jammed();
        rig.Do("OEA=1", "ERA=100", "PAA=0", "BGA").RunToIdle().Do("MOA", "SHA");

        Assert.Equal((0, -2000, 0), (rig.Value("_RPA"), rig.Controller.MotorPlace(0), rig.Value("_MOA")));
        Assert.Equal(-2000, rig.Controller.Record[rig.Controller.Record.Count - 1].A);
    }

    [Fact]
    public async Task Its_shaft_and_not_its_count_meets_the_switches_so_that_homing_finds_the_truth()
    {
        await using var rig = Jammed(new AxisSwitches(0) { HomeAt = -1000 });
        rig.Do("CN ,1", "SPA=8000", "HMA", "BGA").RunToIdle();

        Assert.Equal(-1000, rig.Controller.MotorPlace(0), 1.0);
        Assert.Equal(1000, rig.Value("_RPA"), 1.0);
    }

    [Fact]
    public async Task What_is_called_zero_where_it_stands_is_zero_there()
    {
        await using var rig = Jammed();
        rig.Do("DPA=0", "PAA=300", "BGA").RunToIdle();

        Assert.Equal((300, 5300, 5000), (rig.Value("_RPA"), rig.Controller.MotorPlace(0), rig.Controller.PlaceOf(0, 0)));
    }

    /// <summary>At 5000 of 7000 the shaft was blocked.</summary>
    private static SimulatorRig Jammed(params AxisSwitches[] switches)
    {
        var rig = new SimulatorRig(new SimulatorOptions { Switches = switches });
        rig.Do("MOA", "MTA=2", "SHA", "PAA=5000", "BGA").RunToIdle();
        rig.Controller.HoldMotor(0, true);
        rig.Do("PAA=7000", "BGA").RunToIdle();
        rig.Controller.HoldMotor(0, false);
        return rig;
    }
}
