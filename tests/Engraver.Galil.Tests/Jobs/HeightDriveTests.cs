using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Sessions;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>A tool that is moved by the Z axis: rapids at clearance height, down to the work, up again, and up at every end after which the positions of the
/// axes are reliable (ADR 11). The programs are written by hand and checked by the record.</summary>
public class HeightDriveTests
{
    private const int Clearance = 3200;
    private const int Retract = 800;

    private static readonly MachineProfile s_profile = MachineProfile.Default with
    {
        Axes = MachineAxes.Default with { Z = new MachineAxis('C', 800.0) },
        Height = new HeightDrive { ClearanceHeight = 4.0, RetractHeight = 1.0, PlungeMmPerMinute = 240.0 },
    };

    private static readonly MachineProfile s_turning = s_profile with { Spindle = new Spindle { Output = 3, SpinUpSeconds = 0.5 } };

    public static TheoryData<JobMode> Modes => [JobMode.Stream, JobMode.Calls, JobMode.Program];

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task The_tool_is_up_before_it_travels_and_below_clearance_it_moves_only_straight_down_up_or_along_the_path(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = TwoDepths(s_profile);

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal("Done: 5 segments.", result.Message);
        Assert.Equal(new CountsPoint(0, 0, Clearance), result.FinalPosition);
        AssertMovesAsAllowed(bench, program);
        Assert.All(program.Strokes, stroke => Assert.Contains(bench.Controller.Record.Snapshot(), sample => Place(sample) == stroke.Start));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task Below_the_retract_height_the_tool_goes_down_no_faster_than_the_plunge_feed(JobMode mode)
    {
        await using var bench = new SimulatedBench();

        await bench.RunAsync(TwoDepths(s_profile), SimulatedBench.Job with { Strategy = mode.Strategy() });

        var falls = Pairs(bench).Where(pair => pair.Before.C <= Retract && pair.Now.C < pair.Before.C && (pair.Before.A, pair.Before.B) == (pair.Now.A, pair.Now.B)).ToList();
        Assert.NotEmpty(falls);
        Assert.All(falls, pair => Assert.InRange(pair.Before.C - pair.Now.C, 1, 4)); // 240 mm/min at 800 counts/mm: 3.2 counts a sample
        Assert.Contains(Pairs(bench), pair => pair.Before.C - pair.Now.C > 10); // above it fast
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_stop_brakes_first_and_then_raises_the_tool_straight_up(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();
        var pressed = new CancelWhen(progress => progress.X > 30000 && progress.Place.Z < 0, stop.Cancel);

        var result = await bench.RunAsync(LongSlope(s_turning), SimulatedBench.Job with { Strategy = mode.Strategy() }, pressed, stop.Token);

        Assert.Equal(JobOutcome.Stopped, result.Outcome);
        Assert.InRange(result.FinalPosition!.Value.X, 30000, 90000);
        AssertRaisedAtRest(bench, result.FinalPosition!.Value);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task When_the_host_is_lost_the_watchdog_brakes_raises_the_tool_and_only_then_stops_the_spindle(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var cut = new CancelWhen(progress => progress.X > 30000 && progress.Place.Z < 0, bench.Controller.DropConnections);

        var result = await bench.RunAsync(LongSlope(s_turning), SimulatedBench.Job with { Strategy = mode.Strategy() }, cut);
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(20));

        Assert.Equal(JobOutcome.LinkLost, result.Outcome);
        AssertRaisedAtRest(bench, Place(bench.Last));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task When_an_axis_cannot_follow_the_tool_stays_where_it_is_the_spindle_stops_and_the_sentence_says_so(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("ERA=200", "OEA=1");
        var jam = new CancelWhen(progress => progress.X > 30000, () => bench.Controller.HoldMotor(0, true));

        var result = await bench.RunAsync(LongSlope(s_turning), SimulatedBench.Job with { Strategy = mode.Strategy() }, jam);

        Assert.Contains("following error", result.Message, StringComparison.Ordinal);
        Assert.Contains("The tool could not be raised: axis Z is at", result.Message, StringComparison.Ordinal);
        Assert.InRange(bench.Last.C, -2000, -1);
        Assert.Equal((0, false), (bench.Last.Outputs, bench.Controller.Status.IsMoving));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_dry_run_makes_every_motion_and_its_deepest_cut_passes_at_clearance_height_without_the_spindle(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = TwoDepths(s_turning);

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy(), DryRun = true });

        Assert.Equal(("Done: 5 segments.", JobOutcome.Complete), (result.Message, result.Outcome));
        var record = bench.Controller.Record.Snapshot();
        Assert.Equal(Clearance, record.Where(sample => (sample.A, sample.B) != (0, 0)).Min(sample => sample.C));
        Assert.All(record, sample => Assert.Equal(0, sample.Outputs));
        Assert.Contains(record, sample => (sample.A, sample.B) == (12000, 9000));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task The_spindle_turns_for_its_time_before_the_first_plunge_and_until_the_tool_is_out_of_the_work(JobMode mode)
    {
        await using var bench = new SimulatedBench();

        await bench.RunAsync(TwoDepths(s_turning), SimulatedBench.Job with { Strategy = mode.Strategy() });

        var record = bench.Controller.Record.Snapshot();
        Assert.All(record.Where(sample => sample.C < Retract && (sample.A, sample.B) != (0, 0)), sample => Assert.Equal(4, sample.Outputs));
        var on = record.First(sample => sample.Outputs == 4);
        Assert.InRange(record.First(sample => sample.Sample > on.Sample && sample.C < on.C).Sample - on.Sample, 500, 5000);
        Assert.Equal((0, Clearance), (record[^1].Outputs, on.C));
    }

    [Fact]
    public async Task A_free_axis_gives_the_spindle_its_volts_while_it_turns_and_none_behind_it()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        var profile = s_profile with { Spindle = new Spindle { Output = 3, SpinUpSeconds = 0.0, SpeedAxis = 'D', SpeedVolts = 4.5 } };

        await Engraver.Galil.Jobs.JobRunner.RunAsync(LongSlope(profile), session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.Equal([0.0, 1.0], (await session.Commands.ReadAsync("_OFD,_MOD", CancellationToken.None)).Values);
        Assert.Equal(["MOD", "OFD=4.5", "SB3"], Engraver.Galil.Programs.Subprograms.SpindleOn(profile.Spindle!, null));
        Assert.Equal(["CB3", "OFD=0"], Engraver.Galil.Programs.Subprograms.RestOffCommands(profile));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_motor_type_of_the_profile_is_set_with_its_motor_off_and_stays_set(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var stepper = s_profile with { Axes = new MachineAxes(new MachineAxis('A', 1000.0, 2.0), new MachineAxis('B', 1000.0, -2.0), new MachineAxis('C', 800.0)) };

        var result = await bench.RunAsync(TwoDepths(stepper), SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal("Done: 5 segments.", result.Message);
        await using var session = await bench.OpenAsync();
        Assert.Equal([2.0, -2.0, 1.0], (await session.Commands.ReadAsync("_MTA,_MTB,_MTC", CancellationToken.None)).Values);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task An_output_that_is_active_low_is_off_while_the_tool_works_and_on_everywhere_else(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.Paper with { Profile = MachineProfile.Default with { ToolActiveLow = true, ToolOffSettleSeconds = 0.02 } };

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal("Done: 4 segments.", result.Message);
        var path = new EngravedPath(program);
        Assert.All(Pairs(bench).Where(pair => (pair.Before.A, pair.Before.B) != (pair.Now.A, pair.Now.B) && pair.Now.Outputs == 0), pair => Assert.InRange(path.DistanceTo(pair.Now.A, pair.Now.B), 0, 1.0));
        Assert.InRange(bench.Controller.Record.Snapshot().Count(sample => sample.Outputs == 0 && sample.A >= 5000 && sample.B >= 5000), 2286, 3000); // 45707 counts at 20 a sample
        Assert.Equal(1, bench.Last.Outputs);
    }

    [Fact]
    public async Task A_stop_of_a_tool_that_is_active_low_switches_it_off_by_setting_its_output()
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();

        var result = await bench.RunAsync(
            MotionPrograms.LongLine(200000) with { Profile = MachineProfile.Default with { ToolActiveLow = true } }, SimulatedBench.Job, new CancelWhen(progress => progress.X > 30000, stop.Cancel), stop.Token);

        Assert.Equal(JobOutcome.Stopped, result.Outcome);
        Assert.Equal(1, bench.Last.Outputs);
    }

    /// <summary>Each sample of the record in which the plane moved is at clearance height or above, or on the path; one in which only the height changed is
    /// over an end of a stroke or over the initial position of the tool.</summary>
    private static void AssertMovesAsAllowed(SimulatedBench bench, MotionProgram program)
    {
        var path = program.Strokes.SelectMany(stroke => stroke.Sequences).SelectMany(Points).ToList();
        foreach (var (before, now) in Pairs(bench))
        {
            if ((before.A, before.B) == (now.A, now.B) || now.C >= Clearance) continue;
            Assert.True(path.Any(piece => piece.DistanceTo(now) <= 1.5), $"{now.A},{now.B},{now.C} lies below clearance and beside the path");
        }
    }

    private static void AssertRaisedAtRest(SimulatedBench bench, CountsPoint end)
    {
        Assert.Equal(Clearance, end.Z);
        Assert.Equal((end.X, end.Y, Clearance, 0, false), (bench.Last.A, bench.Last.B, bench.Last.C, bench.Last.Outputs, bench.Controller.Status.IsMoving));
        var pairs = Pairs(bench).ToList();
        var lastInPlan = pairs.FindLastIndex(pair => (pair.Before.A, pair.Before.B) != (pair.Now.A, pair.Now.B));
        Assert.InRange(pairs[lastInPlan].Now.C, -2000, -1); // it braked in the work ...
        Assert.All(pairs.Skip(lastInPlan + 1), pair => Assert.True(pair.Now.C >= pair.Before.C)); // ... and only then went up
        Assert.All(pairs.Where(pair => pair.Now.C < 0 && pair.Now.Sample > 2000), pair => Assert.Equal(4, pair.Now.Outputs)); // the spindle turned while it was in the work
    }

    private static IEnumerable<(MotionSample Before, MotionSample Now)> Pairs(SimulatedBench bench) => bench.Controller.Record.Snapshot() is var record ? record.Zip(record.Skip(1)) : [];

    private static CountsPoint Place(MotionSample sample) => new(sample.A, sample.B, sample.C);

    private static IEnumerable<Piece> Points(VectorSequence sequence)
    {
        var from = sequence.Start;
        foreach (var segment in sequence.Segments)
        {
            yield return new Piece(from, segment.End);
            from = segment.End;
        }
    }

    /// <summary>A level line of two segments, a slope with a level piece in it, and a level square of one side: 5 segments in two strokes.</summary>
    private static MotionProgram TwoDepths(MachineProfile profile) => new(profile, default,
    [
        new MotionStroke(0, new(5000, 0, -400), [Flat(new(5000, 0, -400), new(9000, 0, -400), new(9000, 3000, -400))]),
        new MotionStroke(1, new(12000, 3000, -400), [Slope(new(12000, 3000, -400), 9000, new(12000, 6000, -2000), new(12000, 8000, -2000), new(12000, 9000, -800))]),
    ]) { Finish = default(CountsPoint) };

    /// <summary>From 1000,0 along X to 101000, descending all the way.</summary>
    private static MotionProgram LongSlope(MachineProfile profile) => new(profile, default, [new MotionStroke(0, new(1000, 0, -400), [Slope(new(1000, 0, -400), 20000, new CountsPoint(101000, 0, -2000))])]);

    private static VectorSequence Flat(CountsPoint start, params CountsPoint[] ends) => new(start, 20000, Lines(start, ends));

    private static VectorSequence Slope(CountsPoint start, int speed, params CountsPoint[] ends) => new(start, speed, Lines(start, ends)) { ChangesHeight = true };

    private static List<VectorSegment> Lines(CountsPoint start, CountsPoint[] ends)
    {
        var segments = new List<VectorSegment>();
        foreach (var end in ends)
        {
            var way = end - start;
            segments.Add(new VectorSegment(VectorSegmentKind.Line, end, 0, 0, 0, segments.Count, Math.Sqrt(((double)way.X * way.X) + ((double)way.Y * way.Y) + ((double)way.Z * way.Z))));
            start = end;
        }

        return segments;
    }

    private readonly record struct Piece(CountsPoint From, CountsPoint To)
    {
        public double DistanceTo(MotionSample sample)
        {
            double[] way = [To.X - From.X, To.Y - From.Y, To.Z - From.Z], spoke = [sample.A - From.X, sample.B - From.Y, sample.C - From.Z];
            var foot = Math.Clamp(way.Zip(spoke, (a, b) => a * b).Sum() / way.Sum(a => a * a), 0.0, 1.0);
            return Math.Sqrt(way.Zip(spoke, (a, b) => b - (a * foot)).Sum(off => off * off));
        }
    }
}
