namespace Engraver.Simulator.Tests;

/// <summary>The golden numbers of galil-dmc.md section H. Instruction time (0.5 ms a command) is added to the ideal durations.</summary>
public class ExampleProgramTests
{
    private const double InstructionTime = 0.02;

    [Fact]
    public async Task EX1_line_ends_at_the_programmed_point_and_repeats_relative_to_its_start()
    {
        await using var rig = new SimulatorRig();
        rig.Do("x=3000;y=4000");

        var seconds = rig.Run(ExamplePrograms.Line);

        Assert.Equal(" 3000, 4000, 0, 0\r\n:", rig.Ask("RP"));
        Assert.Equal(5000, rig.Value("_AV"));
        Assert.Equal(" 101, 101, 1, 1\r\n:", rig.Ask("SC"));
        Assert.InRange(seconds, 1.049, 1.049 + InstructionTime);
        rig.Do("XQ#LINEAR,0").RunToIdle().Do("XQ#LINEAR").RunToIdle();
        Assert.Equal(" 9000, 12000, 0, 0\r\n:", rig.Ask("RP"));
    }

    [Fact]
    public async Task EX2_half_circle_counter_clockwise()
    {
        await using var rig = new SimulatorRig();

        var seconds = rig.Run(ExamplePrograms.Arc);

        Assert.Equal(" -5000, 0\r\n".Replace(" -", "-", StringComparison.Ordinal), rig.Ask("RP AB")[..^1]);
        Assert.Equal(7853, rig.Value("_AV"));
        Assert.InRange(seconds, 0.825, 0.825 + InstructionTime);
    }

    [Fact]
    public async Task EX2_quarter_circle_clockwise()
    {
        await using var rig = new SimulatorRig();

        rig.Run(ExamplePrograms.Arc.Replace("CR 2500,0,180", "CR 2500,0,-90", StringComparison.Ordinal));

        Assert.Equal((-2500, -2500, 3926), (rig.Value("_RPA"), rig.Value("_RPB"), rig.Value("_AVS")));
    }

    [Fact]
    public async Task EX3_full_circle_with_pen_down_only_around_the_motion()
    {
        await using var rig = new SimulatorRig();

        var seconds = rig.Run(ExamplePrograms.Circle);

        var samples = rig.Controller.Record.Snapshot();
        Assert.Equal((0, 0, 12566), (rig.Value("_RPA"), rig.Value("_RPB"), rig.Value("_AV")));
        Assert.Equal(-4000, samples.Min(s => s.B));
        Assert.All(samples.SkipLast(1), s => Assert.Equal(1, s.Outputs));
        Assert.Equal(0, samples[^1].Outputs);
        Assert.InRange(seconds, 1.81, 1.81 + InstructionTime);
    }

    [Fact]
    public async Task EX4_track_passes_its_corner_points_and_tells_its_progress()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.Zero });
        rig.Download(ExamplePrograms.Track).Do("XQ");

        rig.Controller.AdvanceUntil(_ => rig.Controller.Record.Count > 0 && rig.Value("_AV") >= 2000, TimeSpan.FromSeconds(2));
        Assert.Equal(0, rig.Value("_CS"));
        rig.Controller.AdvanceUntil(_ => rig.Value("_AV") >= 10712, TimeSpan.FromSeconds(2));
        Assert.Equal((2, -4000, 3000), (rig.Value("_CS"), rig.Value("_VPA"), rig.Value("_VPB")));
        rig.RunToIdle();

        Assert.Equal((0, 0, 17424), (rig.Value("_RPA"), rig.Value("_RPB"), rig.Value("_AV")));
        var samples = rig.Controller.Record.Snapshot();
        Assert.InRange((samples[^1].Sample - samples[0].Sample) / 1000.0, 0.909, 0.913);
        Assert.Contains(samples, s => Math.Abs(s.A + 4000) <= 20 && Math.Abs(s.B - 3000) <= 20);
    }

    [Fact]
    public async Task EX5_drawing_of_the_paper_with_pen()
    {
        await using var rig = new SimulatorRig();
        rig.Do("CFI", "CW2").Download(ExamplePrograms.Draw).Do("XQ");
        var start = rig.Controller.Status.Sample;

        rig.RunToIdle();

        Assert.Equal("DONE 5000.0000 5000.0000\r\n", SimulatorRig.ReadAvailable(rig.Stream));
        Assert.InRange((rig.Controller.Status.Sample - start) / 1000.0, 5.33, 5.33 + (2 * InstructionTime));
        Assert.Equal((45707, 0), (rig.Value("_AV"), rig.Value("_OP0")));
        var samples = rig.Controller.Record.Snapshot();
        Assert.All(samples, s => Assert.True(Deviation(s) <= 1, s.ToString()));

        static double Deviation(MotionSample s) => s.Outputs == 0
            ? Math.Abs(s.A - s.B)
            : new[]
            {
                Math.Abs(s.B - 5000) + Beyond(s.A, 5000, 15000),
                Math.Abs(s.A - 15000) + Beyond(s.B, 5000, 15000),
                Math.Abs(Math.Sqrt(((s.A - 10000.0) * (s.A - 10000.0)) + ((s.B - 15000.0) * (s.B - 15000.0))) - 5000) + Beyond(s.B, 15000, 20000),
                Math.Abs(s.A - 5000) + Beyond(s.B, 5000, 15000),
            }.Min();

        static double Beyond(double value, double low, double high) => Math.Max(0, Math.Max(low - value, value - high));
    }

    [Fact]
    public async Task EX6_tangent_axis_turns_half_a_turn()
    {
        await using var rig = new SimulatorRig();

        var seconds = rig.Run(ExamplePrograms.Knife);

        Assert.Equal((-3000, 0, 1000, 0), (rig.Value("_RPA"), rig.Value("_RPB"), rig.Value("_RPC"), rig.Value("_OP0")));
        Assert.Equal(9424, rig.Value("_AV"));
        Assert.InRange(seconds, 1.62 + 0.228 + 0.05, 1.62 + 0.228 + 0.05 + (2 * InstructionTime)); // path, approach, WT
        var samples = rig.Controller.Record.Snapshot();
        Assert.All(samples.Where(s => s.Outputs == 1), s => Assert.Equal(Knife(s), s.C, 1.0));

        static double Knife(MotionSample s) => Math.Atan2(s.B, s.A) * 180 / Math.PI * 2000 / 360;
    }

    [Fact]
    public async Task EX7_linear_interpolation_of_three_axes()
    {
        await using var rig = new SimulatorRig();

        var seconds = rig.Run(ExamplePrograms.Linear3D);

        var samples = rig.Controller.Record.Snapshot();
        Assert.Equal(" 0, 0, 0, 0\r\n:", rig.Ask("RP"));
        Assert.Equal(11341, rig.Value("_AV"));
        Assert.Contains(samples, s => s is { A: 4000, B: 3000, C: < -600 });
        Assert.InRange(seconds, 1.173, 1.173 + InstructionTime);
    }

    [Fact]
    public async Task EX8_homing_stops_on_the_limit_switch_and_zeroes()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Switches = [new AxisSwitches(0) { ReverseLimitAt = -3000 }] });
        rig.Do("CFI").Download(ExamplePrograms.HomeOnLimit).Do("XQ");
        var start = rig.Controller.Status.Sample;
        rig.Controller.AdvanceUntil(_ => rig.Value("_SCA") == 3, TimeSpan.FromSeconds(2));

        rig.RunToIdle();

        Assert.InRange(rig.Controller.Record.Snapshot().Min(s => s.A), -3036, -3031);
        Assert.Equal("HOMED A 0.0000\r\n", SimulatorRig.ReadAvailable(rig.Stream));
        Assert.Equal((1, 0), (rig.Value("homed"), rig.Value("_RPA")));
        Assert.InRange((rig.Controller.Status.Sample - start) / 1000.0, 1.75, 1.85);
    }

    [Fact]
    public async Task EX8_started_on_the_switch_skips_the_jog()
    {
        await using var rig = new SimulatorRig();
        rig.Controller.SetLimitSwitch(0, forward: false, active: true);

        rig.Download(ExamplePrograms.HomeOnLimit).Do("XQ").RunToIdle();

        Assert.Equal((1, 0), (rig.Value("homed"), rig.Value("_RPA")));
        Assert.Equal(0, rig.Controller.Record.Snapshot().Min(s => s.A));
    }

    [Fact]
    public async Task EX9_a_bad_line_ends_its_thread_and_runs_CMDERR_in_thread_0()
    {
        await using var rig = new SimulatorRig();
        rig.Do("CFI").Download(ExamplePrograms.Handlers).Do("XQ#AUTO,0").Pass(20);

        var messages = rig.Ask("XQ#BAD,1") + SimulatorRig.ReadAvailable(rig.Pass(50).Stream);

        Assert.EndsWith("CMDERR 6.0000\r\n", messages);
        Assert.Equal((1, 6, -1, 1), (rig.Value("nerr"), rig.Value("lerr"), rig.Value("_XQ1"), rig.Value("_HX0") > 0 ? 1 : 0));
    }

    [Fact]
    public async Task EX9_a_limit_runs_LIMSWI_which_stops_the_sequence()
    {
        await using var rig = new SimulatorRig();
        rig.Download(ExamplePrograms.Handlers).Do("XQ#AUTO,0", "SB1", "VMAB", "VP 100000,0", "VE", "BGS").Pass(500);

        rig.Controller.SetLimitSwitch(0, forward: true, active: true);
        rig.Pass(500);

        Assert.Equal((1, 0, 0, 2), (rig.Value("nlim"), rig.Value("_OP0"), rig.Value("_BGS"), rig.Value("_SCA")));
    }

    [Fact]
    public async Task EX9_a_position_error_beyond_ER_runs_POSERR_which_aborts_the_motion()
    {
        await using var rig = new SimulatorRig();
        rig.Do("CFI").Download(ExamplePrograms.Handlers).Do("XQ#AUTO,0", "SB1", "ERA=500", "PRA=100000", "BGA").Pass(100);

        rig.Controller.HoldMotor(0, true);
        rig.Pass(500);

        Assert.Matches(@"^POSERR 5\d\d\.0000 0\.0000\r\n$", SimulatorRig.ReadAvailable(rig.Stream));
        Assert.Equal((1, 0, 0, 7), (rig.Value("npos"), rig.Value("_OP0"), rig.Value("_BGA"), rig.Value("_SCA")));
    }

    [Fact]
    public async Task EX10_feeder_loop_refills_a_full_buffer()
    {
        await using var rig = new SimulatorRig();
        rig.Do("CFI").Download(ExamplePrograms.Stream).Do("XQ").RunToIdle();

        Assert.Equal("END 0.0000 0.0000\r\n", SimulatorRig.ReadAvailable(rig.Stream));
        Assert.InRange(rig.Value("_AV"), 31400, 31425);
        Assert.Equal(0, rig.Controller.Status.Underruns);
    }

    [Fact]
    public async Task EX11_server_draws_what_the_host_assigns()
    {
        await using var rig = new SimulatorRig();
        rig.Download(ExamplePrograms.Server).Do("XQ").Pass(20);
        string[] calls =
        [
            "op=3;x=5000;y=5000", "op=4;x=1", "op=1;x=10000;y=0", "op=1;x=0;y=10000", "op=2;r=5000;th=0;da=180", "op=1;x=0;y=-10000", "op=4;x=0",
        ];

        for (var i = 0; i < calls.Length; i++)
        {
            rig.Do(calls[i], "go=1");
            var wanted = i + 1;
            rig.Controller.AdvanceUntil(_ => rig.Value("seq") == wanted && rig.Value("done") == 1, TimeSpan.FromSeconds(10));
        }

        Assert.Equal((5000, 5000, 7, 0), (rig.Value("_RPA"), rig.Value("_RPB"), rig.Value("seq"), rig.Value("_OP0")));
    }

    [Fact]
    public async Task EX12_watchdog_trips_after_one_second_without_a_heartbeat()
    {
        await using var rig = new SimulatorRig();
        rig.Do("CFI").Download(ExamplePrograms.Watchdog).Do("XQ#WDOG,1");
        var start = rig.Controller.Status.Sample;

        rig.RunToIdle();

        Assert.InRange(rig.Controller.Status.Sample - start, 1000, 1050);
        Assert.Equal("HOST LOST\r\n", SimulatorRig.ReadAvailable(rig.Stream));
        Assert.Equal(1, rig.Value("wtrip"));
    }

    [Fact]
    public async Task EX13_corner_speeds_are_reached_at_the_end_of_their_segments()
    {
        await using var rig = new SimulatorRig();

        var seconds = rig.Run(ExamplePrograms.Square);

        Assert.Equal((0, 0, 40000), (rig.Value("_RPA"), rig.Value("_RPB"), rig.Value("_AV")));
        Assert.InRange(seconds, 2.268, 2.268 + InstructionTime);
        var samples = rig.Controller.Record.Snapshot();
        var corner = Enumerable.Range(0, samples.Count).First(i => samples[i].B > 0);
        Assert.InRange(samples[corner - 1].A - samples[corner - 2].A, 1, 3);
    }

    [Fact]
    public async Task Theory_example_of_the_manual_has_its_length_and_duration()
    {
        await using var rig = new SimulatorRig();
        rig.Do("VMAB", "VS 100000", "VA 2048000", "VD 2048000", "VP 0,10000", "CR 10000,180,-90", "VP 20000,20000", "VE");

        rig.Do("BGS").RunToIdle();

        Assert.Equal((20000, 20000, 35707), (rig.Value("_RPA"), rig.Value("_RPB"), rig.Value("_AV")));
        var samples = rig.Controller.Record.Snapshot();
        Assert.InRange((samples[^1].Sample - samples[0].Sample) / 1000.0, 0.405, 0.409);
    }

    [Fact]
    public async Task Check_example_of_B1_progress_inside_the_first_and_second_segment()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.Zero });
        rig.Do("LM XY", "VS 10000", "LI 5000,0", "LI 0,5000", "LE", "BGS");

        rig.Controller.AdvanceUntil(_ => rig.Value("_RPX") >= 3000, TimeSpan.FromSeconds(2));
        Assert.Equal(rig.Value("_RPX"), rig.Value("_AV"), 1.0);
        Assert.Equal((0, 0, 0), (rig.Value("_CS"), rig.Value("_VPX"), rig.Value("_VPY")));
        rig.Controller.AdvanceUntil(_ => rig.Value("_RPY") >= 2000, TimeSpan.FromSeconds(2));
        Assert.Equal(5000 + rig.Value("_RPY"), rig.Value("_AV"), 1.0);
        Assert.Equal((1, 5000, 0), (rig.Value("_CS"), rig.Value("_VPX"), rig.Value("_VPY")));
    }
}
