using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>HOLD of a tool that is moved by an axis: it brakes on the path, the tool moves straight up, and RESUME returns to the position, plunges and
/// continues. Every sample of the simulator's record is checked.</summary>
public class HeightHoldTests
{
    private const int Network = 0;

    /// <summary>In the level line, in the arc, in the slope, in the vertical piece of the slope, in the last line, in a rapid between, in a plunge.</summary>
    public static TheoryData<JobMode, string> Everywhere
    {
        get
        {
            var all = new TheoryData<JobMode, string>();
            foreach (var (where, mode, _) in TestExtent.InTurn(["line", "arc", "slope", "upright", "last", "rapid", "plunge"], Enum.GetValues<JobMode>(), [true])) all.Add(mode, where);
            return all;
        }
    }

    [Theory]
    [MemberData(nameof(Everywhere))]
    public async Task A_held_tool_goes_up_at_rest_and_comes_back_to_its_place(JobMode mode, string where)
    {
        await using var bench = new SimulatedBench();
        var program = HeightBench.Part(style: mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);
        var operators = new HoldingOperator(bench, At(where), heldSeconds: 9.0);

        var result = await HoldTests.RunAsync(bench, program, mode, Network, operators);

        Assert.Equal(("Done: 9 segments.", 1), (result.Message, result.Holds));
        HeightBench.AssertCut(bench, program);
        HeightBench.AssertGentle(bench, program);
        HeightBench.AssertStoodUp(bench, operators);
        Assert.Equal(program.SegmentCount, result.ExecutedByStroke.Sum());
        Assert.Equal(program.Strokes.Sum(stroke => stroke.Sequences.Sum(sequence => sequence.Length)), result.LengthByStroke.Sum(), 5.0);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task Many_holds_in_one_job_leave_nothing_out(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = HeightBench.Part(style: mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);
        var operators = new HoldingOperator(bench, at: _ => true, heldSeconds: 1.0) { Repeats = 10, Between = 0.9 };

        var result = await HoldTests.RunAsync(bench, program, mode, Network, operators);

        Assert.Equal("Done: 9 segments.", result.Message);
        Assert.InRange(result.Holds, 6, 10);
        HeightBench.AssertCut(bench, program, most: 10.0 * result.Holds);
        HeightBench.AssertGentle(bench, program);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task So_it_is_over_a_serial_line(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = HeightBench.Part(style: mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);
        var operators = new HoldingOperator(bench, At("slope"), heldSeconds: 9.0);

        var result = await HoldTests.RunAsync(bench, program, mode, 19200, operators);

        Assert.Equal(("Done: 9 segments.", 1), (result.Message, result.Holds));
        HeightBench.AssertCut(bench, program);
        HeightBench.AssertStoodUp(bench, operators);
    }

    [Theory]
    [InlineData(JobMode.Stream, "slope")]
    [InlineData(JobMode.Calls, "slope")]
    [InlineData(JobMode.Program, "slope")]
    [InlineData(JobMode.Stream, "rapid")]
    [InlineData(JobMode.Calls, "rapid")]
    [InlineData(JobMode.Program, "rapid")]
    public async Task A_spindle_that_is_set_to_stop_in_a_hold_stands_once_the_tool_is_up_and_turns_before_it_plunges(JobMode mode, string where)
    {
        await using var bench = new SimulatedBench();
        var profile = HeightBench.Profile with { Spindle = HeightBench.Profile.Spindle! with { StopsInHold = true } };
        var program = HeightBench.Part(profile, mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);
        var operators = new HoldingOperator(bench, At(where), heldSeconds: 3.0);

        var result = await HoldTests.RunAsync(bench, program, mode, Network, operators);

        Assert.Equal(("Done: 9 segments.", 1), (result.Message, result.Holds));
        HeightBench.AssertCut(bench, program);
        HeightBench.AssertGentle(bench, program); // it turned whenever the tool was in the work
        var record = bench.Controller.Record.Snapshot();
        var (from, to) = Assert.Single(operators.Held);
        Assert.Equal(0, record.Last(sample => sample.Sample <= to).Outputs);
        Assert.InRange(record.First(sample => sample.Sample > to && sample.C < HeightBench.Clearance).Sample - to, 500, 5000); // the spin-up time before the plunge
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_dry_run_is_held_without_a_spindle(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = HeightBench.Part(style: mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);
        var operators = new HoldingOperator(bench, At("slope"), heldSeconds: 3.0);

        var result = await HoldTests.RunAsync(bench, program, mode, Network, operators, dryRun: true);

        Assert.Equal(("Done: 9 segments.", 1), (result.Message, result.Holds));
        Assert.All(bench.Controller.Record.Snapshot(), sample => Assert.Equal(0, sample.Outputs));
    }

    internal static Func<JobProgress, bool> At(string where) => where switch
    {
        "line" => now => now is { Y: 0, X: > 12000, Place.Z: < 0 },
        "arc" => now => now is { X: > 27000, Y: > 3000 and < 10000 },
        "slope" => now => now is { Y: 30000, X: > 10500 and < 20000, Place.Z: < 0 }, // it brakes in the second of its lines
        "upright" => now => now is { Y: 30000, X: 25000, Place.Z: < -2430 },
        "last" => now => now is { Y: 60000, X: > 15000, Place.Z: < 0 },
        "rapid" => now => now is { Place.Z: >= HeightBench.Clearance, Y: > 15000 and < 25000 },
        _ => now => now is { X: 5000, Y: 60000, Place.Z: < 3000 },
    };
}
