using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Simulator.Tests;

/// <summary>galil-dmc.md B.1 to B.8.</summary>
public class VectorMotionTests
{
    private static readonly string[] Setup = ["VMAB", "VS 20000", "VA 256000", "VD 256000"];

    [Fact]
    public async Task Origin_is_latched_at_BGS_and_VP_is_absolute_in_the_sequence()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Setup).Do("VP 100,0", "VP 100,100", "VE", "DPA=5000;DPB=-7", "BGS").RunToIdle();

        Assert.Equal((5100, 93), (rig.Value("_RPA"), rig.Value("_RPB")));
    }

    [Fact]
    public async Task Axis_order_follows_VM()
    {
        await using var rig = new SimulatorRig();
        rig.Do("VMBA", "VP 100,30", "VE", "BGS").RunToIdle();

        Assert.Equal((30, 100), (rig.Value("_RPA"), rig.Value("_RPB")));
    }

    [Fact]
    public async Task The_real_end_of_an_arc_is_kept_and_VP_absorbs_it()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { AngleQuantumDegrees = 1.0 / 256 });
        rig.Do(Setup).Do("CR 100000,0.002,90", "VP -100000,100000", "VE", "BGS").RunToIdle();

        Assert.Equal((-100000, 100000), (rig.Value("_RPA"), rig.Value("_RPB")));
        Assert.InRange(rig.Value("_AV"), 157079, 157090);
    }

    [Theory]
    [InlineData(1.0, -1000)]
    [InlineData(0.0, -1001)]
    public async Task Radius_quantum_cuts_the_radius(double quantum, int end)
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { RadiusQuantum = quantum });
        rig.Do(Setup).Do("CR 1000.6,0,90", "VE", "BGS").RunToIdle();

        Assert.Equal((end, -end), (rig.Value("_RPA"), rig.Value("_RPB")));
    }

    [Theory]
    [InlineData("VP 0,0", 30)]
    [InlineData("CR 9,0,90", 6)]
    [InlineData("CR 6000001,0,1", 6)]
    [InlineData("CR 1000,0,0", 30)]
    [InlineData("CR 1000,32001,10", 6)]
    [InlineData("CR 3000000,0,150", 6)]
    [InlineData("CR 1000,0", 50)]
    [InlineData("VP 100", 50)]
    [InlineData("VP 9000000,0", 6)]
    [InlineData("VP 10,0<1", 6)]
    [InlineData("VP 10,0>8000002", 6)]
    [InlineData("LI 10,10", 33)]
    [InlineData("BGS", 24)]
    public async Task Segments_outside_the_ranges_are_refused(string command, int code)
    {
        await using var rig = new SimulatorRig();
        rig.Do(Setup);

        Assert.Equal(code, rig.Refusal(command));
        Assert.Equal(511, rig.Value("_LM"));
    }

    [Fact]
    public async Task LM_refuses_VP_and_zero_increments_and_too_much_before_BGS()
    {
        await using var rig = new SimulatorRig();
        rig.Do("LMABC");

        Assert.Equal(33, rig.Refusal("VP 1,1"));
        Assert.Equal(30, rig.Refusal("LI 0,0,0"));
        Assert.Equal(6, rig.Refusal("LI 8388608"));
        Assert.Equal(90, rig.Refusal("LI ,,,5"));
        rig.Do("LI 1600,,,,");
        for (var i = 0; i < 127; i++) rig.Do("LI 8388607");

        Assert.Equal(31, rig.Refusal("LI 8388607"));
    }

    [Fact]
    public async Task The_buffer_holds_511_segments_and_takes_more_as_slots_free_up()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Setup);
        for (var i = 1; i <= 511; i++) rig.Do($"VP {i * 100},0");

        Assert.Equal((0, 32), (rig.Value("_LMS"), rig.Refusal("VP 60000,0")));
        rig.Do("BGS").Pass(100);
        var free = (int)rig.Value("_LMS");
        Assert.InRange(free, 1, 30);
        Assert.InRange(rig.Value("_CSS") - free, 0, 1);
        rig.Do("VP 60000,0", "VE").RunToIdle();
        Assert.Equal((60000, 512, 101), (rig.Value("_RPA"), rig.Value("_CS"), rig.Value("_SCA")));
    }

    [Fact]
    public async Task While_a_sequence_runs_what_needs_standstill_is_code_7()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Setup).Do("VP 100000,0", "BGS");

        Assert.All(new[] { "CSS", "VMAB", "LMAB", "VD 102400", "VDS=102400", "PAA=5", "PRB=5", "DPA=0", "MOA", "SH" }, c => Assert.Equal(7, rig.Refusal(c)));
        Assert.Equal((21, 29), (rig.Refusal("BGS"), rig.Refusal("BGA")));
        rig.Do("VA 102400", "VS 10000", "VP 200000,0", "VE");
        Assert.Equal(7, rig.Refusal("VP 300000,0"));
    }

    [Fact]
    public async Task Begin_with_a_motor_off_is_code_20()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Setup).Do("VP 1000,0", "VE", "MOB");

        Assert.Equal((20, 20), (rig.Refusal("BGS"), rig.Refusal("BGB")));
        rig.Do("SHB", "BGS");
    }

    [Fact]
    public async Task Running_dry_stops_at_once_and_stays_open_until_fed_or_closed()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Setup).Do("VP 5000,0", "BGS").Pass(1000);

        Assert.Equal((5000, 1, 100, 1), (rig.Value("_RPA"), rig.Value("_BGS"), rig.Value("_SCA"), rig.Controller.Status.Underruns));
        Assert.Equal(0, rig.Value("_VMS"));
        rig.Do("STS").Pass(50);
        Assert.Equal(1, rig.Value("_BGS"));
        rig.Do("VP 9000,0").Pass(1000);
        Assert.Equal((9000, 2), (rig.Value("_RPA"), rig.Controller.Status.Underruns));
        rig.Do("VE").Pass(2);
        Assert.Equal((0, 101), (rig.Value("_BGS"), rig.Value("_SCA")));
        var samples = rig.Controller.Record.Snapshot();
        var end = Enumerable.Range(0, samples.Count).First(i => samples[i].A == 5000);
        Assert.True(samples[end].A - samples[end - 2].A > 10, "it did not brake");
    }

    [Fact]
    public async Task AB1_ends_a_dry_sequence_with_code_7_and_leaves_programs_alone()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#A\nWT 10\nJP#A").Do("XQ").Do(Setup).Do("VP 5000,0", "BGS").Pass(1000);

        rig.Do("AB1");

        Assert.Equal((0, 7, 1), (rig.Value("_BGS"), rig.Value("_SCA"), rig.Value("_NO")));
        rig.Do("CSS", "AB");
        Assert.Equal(0, rig.Value("_NO"));
    }

    [Fact]
    public async Task VE_brakes_over_several_segments_and_ends_exactly()
    {
        await using var rig = new SimulatorRig();
        rig.Do("VMAB", "VS 100000", "VA 256000", "VD 256000");
        for (var i = 1; i <= 400; i++) rig.Do($"VP {i * 100},0");

        rig.Do("VE", "BGS").RunToIdle();

        var steps = Steps(rig);
        Assert.Equal(40000, rig.Value("_RPA"));
        Assert.All(steps.Skip(1).Zip(steps), p => Assert.InRange(p.First - p.Second, -2, 2));
        Assert.InRange(steps[^1], 0, 2);
    }

    [Fact]
    public async Task STS_decelerates_at_VD_and_gives_the_rest_up()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Setup).Do("VP 50000,0", "VP 100000,0", "VE", "BGS").Pass(1000);
        var start = rig.Value("_RPA");

        rig.Do("STS");
        Assert.Equal(4, rig.Value("_SCA"));
        rig.Do("VD 512000").Do("VD 256000").RunToIdle();

        Assert.InRange(rig.Value("_RPA") - start, 781 - 90, 781 + 90);
        Assert.Equal((0, 511, 4), (rig.Value("_BGS"), rig.Value("_LMS"), rig.Value("_SCA")));
        rig.Do("CSS").Do("VP 100,0", "VE", "BGS").RunToIdle();
    }

    [Fact]
    public async Task VR_0_holds_the_feed_and_VR_1_resumes_on_the_path()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Setup).Do("VP 20000,0", "VE", "BGS").Pass(300);

        rig.Do("VR 0").Pass(200);
        Assert.Equal((0, 1), (rig.Value("_VMS"), rig.Value("_BGS")));
        var held = rig.Value("_RPA");
        var rows = rig.Controller.Record.Count;
        rig.Pass(5000);
        Assert.Equal((held, rows), (rig.Value("_RPA"), rig.Controller.Record.Count));

        rig.Do("VR 1").RunToIdle();
        Assert.Equal((20000, 101), (rig.Value("_RPA"), rig.Value("_SCA")));
        Assert.All(Steps(rig).Skip(1).Zip(Steps(rig)), p => Assert.InRange(p.First - p.Second, -2, 2));
    }

    [Fact]
    public async Task VR_scales_every_speed_and_VS_works_in_motion()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Setup).Do("VP 50000,0<10000", "VP 100000,0", "VE", "VR 0.5", "BGS").Pass(500);
        Assert.Equal(5000, rig.Value("_VMS"));

        rig.Do("VR 2").Pass(500);
        Assert.Equal(20000, rig.Value("_VMS"));
        rig.Do("VS 4000").Pass(500);
        Assert.Equal(8000, rig.Value("_VMS"));
    }

    [Fact]
    public async Task A_faster_exit_speed_is_reached_at_the_end_of_its_segment()
    {
        await using var rig = new SimulatorRig();
        rig.Do("VMAB", "VS 4000", "VA 256000", "VD 256000", "VP 5000,0>12000", "VP 5000,5000", "VE", "BGS").RunToIdle();

        var samples = rig.Controller.Record.Snapshot();
        var corner = Enumerable.Range(0, samples.Count).First(i => samples[i].A == 5000);
        Assert.InRange(samples[corner - 1].A - samples[corner - 2].A, 11, 12);
    }

    [Theory]
    [InlineData(false, 20000, 20000)]
    [InlineData(true, 12000, 4000)]
    public async Task An_early_ramp_begins_with_its_segment_and_its_speed_is_held(bool early, double afterStart, double halfway)
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { EarlyRamps = early });
        rig.Do(Setup).Do("VP 10000,0", "VP 40000,0>4000", "VP 50000,0", "VE", "BGS").RunToIdle();

        Assert.Equal(20000, SpeedAt(rig, 10_000), 300.0);
        Assert.Equal(afterStart, SpeedAt(rig, 10_500), 1000.0);
        Assert.Equal(halfway, SpeedAt(rig, 25_000), 300.0);
        Assert.Equal(4000, SpeedAt(rig, 40_000), 1000.0);
        Assert.Equal(20000, SpeedAt(rig, 45_000), 300.0);
        Assert.Equal((50000, 101), (rig.Value("_RPA"), rig.Value("_SCA")));
    }

    [Fact]
    public async Task An_early_ramp_also_accelerates_and_overrides_VS_up_to_the_end_of_its_segment()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { EarlyRamps = true });
        rig.Do("VMAB", "VS 4000", "VA 256000", "VD 256000", "VP 20000,0<6000>12000", "VP 40000,0", "VE", "BGS").Pass(500);
        Assert.Equal(12000, rig.Value("_VMS"));

        rig.Do("VR 0.5", "VS 5000").Pass(100);
        Assert.Equal(6000, rig.Value("_VMS"));
        rig.Do("VR 1").Pass(2000);
        Assert.Equal((1, 5000), (rig.Value("_CSS"), rig.Value("_VMS")));
    }

    [Fact]
    public async Task An_early_ramp_to_0_ends_with_its_segment()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { EarlyRamps = true });
        rig.Do(Setup).Do("VP 10000,0>0", "VP 20000,0", "VE", "BGS").RunToIdle();

        Assert.Equal((20000, 101), (rig.Value("_RPA"), rig.Value("_SCA")));
    }

    [Theory]
    [InlineData(false, 4000)]
    [InlineData(true, 20000)]
    public async Task A_second_pending_exit_speed_is_ignored(bool one, double second)
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { OnePendingExit = one });
        rig.Do(Setup).Do("VP 10000,0>8000", "VP 20000,0>4000", "VP 40000,0", "VE", "BGS").RunToIdle();

        Assert.Equal(8000, SpeedAt(rig, 10_000), 1000.0);
        Assert.Equal(second, SpeedAt(rig, 20_000), 1000.0);
    }

    [Fact]
    public async Task An_exit_speed_counts_again_once_the_pending_one_is_executed_or_removed()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { OnePendingExit = true });
        rig.Do(Setup).Do("VP 10000,0>8000", "VP 20000,0", "BGS");
        Assert.True(rig.Controller.AdvanceUntil(s => s.SegmentsExecuted == 1, TimeSpan.FromSeconds(5)));
        rig.Do("VP 30000,0>4000", "VP 40000,0", "VE").RunToIdle();
        rig.Do("VP 10000,0>8000", "CSS", "VP 10000,0>6000", "VP 20000,0", "VE", "BGS").RunToIdle();

        Assert.Equal(8000, SpeedAt(rig, 10_000), 1000.0);
        Assert.Equal(4000, SpeedAt(rig, 30_000), 1000.0);
        Assert.Equal(6000, SpeedAt(rig, 50_000), 1000.0);
    }

    [Theory]
    [InlineData(false, 8000, 3000)]
    [InlineData(true, 20000, 8000)]
    public async Task An_entry_speed_applies_until_the_next_one_or_to_its_own_segment(bool own, double second, double afterVs)
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { OwnEntrySpeed = own });
        rig.Do(Setup).Do("VP 10000,0<8000", "VP 30000,0", "VE", "BGS").RunToIdle();
        Assert.Equal(8000, SpeedAt(rig, 9000), 300.0);
        Assert.Equal(second, SpeedAt(rig, 20_000), 300.0);

        rig.Do("VP 10000,0<8000", "VP 30000,0", "VE", "BGS").Pass(200);
        rig.Do("VS 3000").Pass(200);
        Assert.Equal((0, afterVs), (rig.Value("_CSS"), rig.Value("_VMS")));
        rig.RunToIdle();
        Assert.Equal(3000, SpeedAt(rig, 50_000), 300.0);
    }

    [Fact]
    public async Task AV_counts_from_the_previous_AV_and_switches_outputs_on_the_path()
    {
        await using var rig = new SimulatorRig();
        rig.Download("BGS\nAV 2000;SB1\nAV 3000;CB1\nAMS\nEN").Do(Setup).Do("VP 10000,0", "VE", "XQ").RunToIdle();

        var lit = rig.Controller.Record.Snapshot().Where(s => s.Outputs == 1).ToArray();
        Assert.InRange(lit[0].A, 2000, 2080);
        Assert.InRange(lit[^1].A, 5000, 5080);
    }

    [Fact]
    public async Task The_tangent_axis_turns_backwards_on_a_clockwise_arc()
    {
        await using var rig = new SimulatorRig();
        rig.Do("VMABC", "TN 2000/360,-500", "CR 3000,180,-180", "VE");
        Assert.Equal(0, rig.Value("_TNS"));

        rig.Do("BGS").RunToIdle();

        Assert.Equal((6000, 0, -1000), (rig.Value("_RPA"), rig.Value("_RPB"), rig.Value("_RPC")));
    }

    [Fact]
    public async Task Plane_T_works_beside_plane_S()
    {
        await using var rig = new SimulatorRig();
        rig.Do("VMAB", "VP 1000,0", "VE", "CAT", "LMCD", "VST=4000", "LI ,,500,-500", "LE", "BGST").RunToIdle();

        Assert.Equal(" 1000, 0, 500, -500\r\n:", rig.Ask("RP"));
    }

    [Fact]
    public async Task A_single_axis_with_the_virtual_one_makes_a_sine()
    {
        await using var rig = new SimulatorRig();
        rig.Do("VMAN", "VS 20000", "CR 1000,90,360", "VE", "BGS").RunToIdle();

        var samples = rig.Controller.Record.Snapshot();
        Assert.Equal((1000, -1000, 0), (samples.Max(s => s.A), samples.Min(s => s.A), samples[^1].A));
    }

    [Property]
    public Property Every_sample_of_a_random_polyline_lies_on_it_and_it_ends_exactly() =>
        Prop.ForAll(Polylines.ToArbitrary(), points =>
        {
            var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.FromMilliseconds(0.1) });
            rig.Do("VMAB", "VS 60000", "VA 1024000", "VD 1024000");
            foreach (var (x, y) in points) rig.Do($"VP {x},{y}");

            rig.Do("VE", "BGS").RunToIdle(600);
            var samples = rig.Controller.Record.Snapshot();
            var path = points.Prepend((0, 0)).ToArray();
            return (samples[^1].A, samples[^1].B) == points[^1] && samples.All(s => Distance(path, s) <= 0.75);
        });

    private static Gen<(int X, int Y)[]> Polylines =>
        Gen.Choose(-3000, 3000).Two().Select(t => (t.Item1, t.Item2)).NonEmptyListOf()
            .Select(l => l.Prepend((1, 1)).ToArray())
            .Select(p => p.Where((q, i) => i == 0 || q != p[i - 1]).ToArray());

    private static double Distance((int X, int Y)[] path, MotionSample s)
    {
        var best = double.PositiveInfinity;
        for (var i = 1; i < path.Length; i++)
        {
            double dx = path[i].X - path[i - 1].X;
            double dy = path[i].Y - path[i - 1].Y;
            var t = Math.Clamp((((s.A - path[i - 1].X) * dx) + ((s.B - path[i - 1].Y) * dy)) / ((dx * dx) + (dy * dy)), 0, 1);
            best = Math.Min(best, double.Hypot(s.A - path[i - 1].X - (t * dx), s.B - path[i - 1].Y - (t * dy)));
        }

        return best;
    }

    /// <summary>The mean speed of axis A over the four samples before it reaches a position, counts/s.</summary>
    private static double SpeedAt(SimulatorRig rig, int place)
    {
        var samples = rig.Controller.Record.Snapshot();
        var there = Enumerable.Range(0, samples.Count).First(i => samples[i].A >= place);
        return (samples[there].A - samples[there - 4].A) * 250.0;
    }

    private static int[] Steps(SimulatorRig rig)
    {
        var samples = rig.Controller.Record.Snapshot();
        return [.. samples.Skip(1).Zip(samples).Where(p => p.First.Sample == p.Second.Sample + 1).Select(p => p.First.A - p.Second.A)];
    }
}
