namespace Engraver.Simulator.Tests;

/// <summary>The lagging or held motor: TE, #POSERR, MC, TW (galil-dmc.md C, I.14).</summary>
public class ServoTests
{
    private const string Mover = "#GO\nhere=0\nPRA=1000\nBGA\nMCA\nhere=_TPA\nEN\n#MCTIME\nlate=1\nEN\n";

    [Fact]
    public async Task A_lagging_motor_shows_its_error_in_motion_and_arrives()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { ServoLag = TimeSpan.FromMilliseconds(10) });
        rig.Do("JGA=20000", "BGA").Pass(300);

        Assert.Equal(200, rig.Value("_TEA"), 15.0); // speed times lag
        rig.Do("STA").RunToIdle();
        Assert.Equal((0, rig.Value("_RPA")), (rig.Value("_TEA"), rig.Value("_TPA")));
    }

    [Fact]
    public async Task MC_waits_for_the_motor_where_AM_waits_for_the_profile()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { ServoLag = TimeSpan.FromMilliseconds(50) });

        var seconds = rig.Do("late=0").Run(Mover);

        Assert.Equal((1000, 0), (rig.Value("here"), rig.Value("late")));
        Assert.True(seconds > 0.125 + 0.15, $"{seconds} s: the profile alone takes 0.125 s");
    }

    [Fact]
    public async Task A_motor_that_does_not_arrive_within_TW_gets_code_99_and_runs_MCTIME()
    {
        await using var rig = new SimulatorRig();
        rig.Controller.HoldMotor(0, true);

        var seconds = rig.Do("late=0", "TWA=200").Run(Mover);

        Assert.Equal((0, 1, 99), (rig.Value("here"), rig.Value("late"), rig.Value("_SCA")));
        Assert.InRange(seconds, 0.325, 0.345);
    }

    [Fact]
    public async Task With_OE_1_an_error_stops_all_axes_of_the_sequence_and_their_motors()
    {
        await using var rig = new SimulatorRig();
        rig.Do("OEA=1", "ERA=300", "VMAB", "VP 50000,50000", "VE", "BGS").Pass(100);

        rig.Controller.HoldMotor(0, true);
        rig.RunToIdle();

        Assert.Equal((1, 1, 8, 8), (rig.Value("_MOA"), rig.Value("_MOB"), rig.Value("_SCA"), rig.Value("_SCB")));
    }

    [Fact]
    public async Task SH_takes_the_place_of_the_motor_as_command()
    {
        await using var rig = new SimulatorRig();
        rig.Controller.HoldMotor(0, true);
        rig.Do("PRA=1000", "BGA").RunToIdle();
        Assert.Equal(1000, rig.Value("_TEA"));

        rig.Do("MOA", "SHA");

        Assert.Equal((0, 0), (rig.Value("_TEA"), rig.Value("_RPA")));
    }
}
