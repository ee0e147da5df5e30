using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Tests.Jobs.Holds;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>Outputs, speeds of the spindle and powers that operations state, by the record of the controller and by its own values.</summary>
public class StrokeOutputsTests
{
    private const int Air = 0b010;
    private const int Coolant = 0b100;

    public static TheoryData<JobMode> Modes => [JobMode.Stream, JobMode.Calls, JobMode.Program];

    /// <summary>Air at the first stroke, air and coolant at the second, neither at the third.</summary>
    [Theory]
    [MemberData(nameof(Modes))]
    public async Task The_outputs_of_an_operation_are_on_while_it_is_cut_and_off_at_the_end(JobMode mode)
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(Lines(mode, Air, Air | Coolant, 0), SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.Equal([Air, Air | Coolant, 0], CutWith(bench));
        Assert.Equal(0, bench.Last.Outputs);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_dry_run_leaves_the_outputs_off(JobMode mode)
    {
        await using var bench = new SimulatedBench();

        await bench.RunAsync(Lines(mode, Air, Coolant), SimulatedBench.Job with { Strategy = mode.Strategy(), DryRun = true });

        Assert.All(bench.Controller.Record.Snapshot(), sample => Assert.Equal(0, sample.Outputs));
    }

    /// <summary>In a hold the tool is off and the outputs stay; behind a stop everything is off.</summary>
    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_hold_keeps_the_outputs_and_a_stop_switches_them_off(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();
        var operators = new HoldingOperator(bench, progress => progress.ToolOn && progress.Seconds > 0.3, 1.0);

        var result = await bench.RunAsync(Lines(mode, Air, Coolant), SimulatedBench.Job with { Strategy = mode.Strategy(), Control = operators.Control }, operators);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        var (from, to) = Assert.Single(operators.Held);
        Assert.Equal(Air, bench.Controller.Record.Snapshot().Last(sample => sample.Sample > from - 500 && sample.Sample < to).Outputs);
        Assert.Equal([Air, Coolant], CutWith(bench));

        var stopped = await bench.RunAsync(Lines(mode, Air, Coolant), SimulatedBench.Job with { Strategy = mode.Strategy() }, new CancelWhen(progress => progress is { ToolOn: true, Seconds: > 0.3 }, stop.Cancel), stop.Token);
        Assert.Equal((JobOutcome.Stopped, 0), (stopped.Outcome, bench.Last.Outputs));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task The_analog_output_has_the_volts_of_the_stroke_and_none_behind_the_job(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = Lines(mode, 0, 0);
        program = program with
        {
            Profile = program.Profile with { Power = new AnalogOutput('D', 8.0) },
            Strokes = [.. program.Strokes.Select((stroke, index) => stroke with { Terms = new StrokeTerms(0, 0.0, 0.0) { Volts = index == 0 ? 2.0 : 6.0 } })],
        };
        IProgress<JobProgress> Watch(int stroke) => new CancelWhen(progress => progress.ToolOn && progress.Stroke == stroke && progress.Place.X > 4000, () => bench.Interfere($"v{stroke}=_OFD"));
        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy() }, new ProgressPair(Watch(0), Watch(1)));

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.Equal((2.0, 6.0, 0.0, 1.0), (await ValueAsync("v0"), await ValueAsync("v1"), await ValueAsync("_OFD"), await ValueAsync("_MOD")));

        async Task<double> ValueAsync(string operand) => double.Parse(await bench.NumberAsync(operand), System.Globalization.CultureInfo.InvariantCulture);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_stop_takes_the_power_away(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();
        var program = Lines(mode, 0, 0);
        program = program with { Profile = program.Profile with { OperationOutputs = 0, Power = new AnalogOutput('D', 8.0) }, Strokes = [.. program.Strokes.Select(stroke => stroke with { Terms = new StrokeTerms(0, 0.0, 0.0) { Volts = 5.0 } })] };

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy() }, new CancelWhen(progress => progress is { ToolOn: true, Seconds: > 0.3 }, stop.Cancel), stop.Token);

        Assert.Equal((JobOutcome.Stopped, "0"), (result.Outcome, await bench.NumberAsync("_OFD")));
    }

    /// <summary>A job with outputs left its program; what was the owner's is given back all the same by a job without them.</summary>
    [Fact]
    public void A_program_that_switches_outputs_is_known_as_our_own_under_every_profile()
    {
        var profile = MachineProfile.Default;
        foreach (var outputs in (int[])[0, Air, Air | Coolant, 0b11111110])
        {
            Assert.True(Engraver.Galil.Jobs.Execution.ResidentServer.IsOwn(Engraver.Galil.Jobs.Execution.ResidentServer.Program(JobMode.Stream, profile with { OperationOutputs = outputs }).Text, profile));
        }

        Assert.False(Engraver.Galil.Jobs.Execution.ResidentServer.IsOwn("#AUTO\nSB2\nEN\n", profile));
    }

    /// <summary>Each part starts the spindle at the speed of its first stroke.</summary>
    [Fact]
    public void A_program_in_several_parts_starts_each_at_its_own_speed()
    {
        var program = Lines(JobMode.Stream, 0, 0);
        program = program with
        {
            Profile = program.Profile with { OperationOutputs = 0, Spindle = new Spindle { Output = 4, SpeedAxis = 'D', SpeedVolts = 9.0, SpinUpSeconds = 1.5, FullSpeed = 18000.0 } },
            Strokes = [.. program.Strokes.Select((stroke, index) => stroke with { Sequences = [stroke.Sequences[0] with { Segments = [.. Enumerable.Range(1, 200).Select(i => HeightBench.Line(new(2000 + (100 * (i - 1)), stroke.Start.Y), new(2000 + (100 * i), stroke.Start.Y)))] }], Terms = new StrokeTerms(0, 0.0, 0.0) { Volts = 3.0 * (index + 1), ReadySeconds = 1.5 * index } })],
        };
        var parts = DmcPost.Sequences(program, DmcPostOptions.Default with { MemoryLines = 60 }).Chunks;

        Assert.Equal(2, parts.Count);
        Assert.Equal(["MOD;OFD=3;SB4;WT 1500", "MOD;OFD=6;SB4;WT 1500"], parts.Select(part => part.Split('\n').Single(line => line.StartsWith("MOD", StringComparison.Ordinal))));
    }

    [Theory]
    [InlineData(MotionStyle.Continuous)]
    [InlineData(MotionStyle.Calls)]
    public void A_posted_program_sets_them_before_each_stroke_and_switches_everything_off(MotionStyle style)
    {
        var program = Lines(style == MotionStyle.Calls ? JobMode.Calls : JobMode.Stream, Air, Coolant);
        program = program with
        {
            Profile = program.Profile with { Spindle = new Spindle { Output = 4, SpeedAxis = 'D', SpeedVolts = 9.0, SpinUpSeconds = 1.5, FullSpeed = 18000.0 } },
            Strokes = [program.Strokes[0] with { Terms = program.Strokes[0].Terms! with { Volts = 3.0 } }, program.Strokes[1] with { Terms = program.Strokes[1].Terms! with { Volts = 6.0, ReadySeconds = 1.5 } }],
        };
        var lines = (style == MotionStyle.Calls ? DmcPost.Calls(program, DmcPostOptions.Default) : DmcPost.Sequences(program, DmcPostOptions.Default)).Text.Split('\n');

        Assert.Contains("MOD;OFD=3;SB4;WT 1500", lines);
        Assert.Contains("SB2;CB3;OFD=3", lines);
        Assert.Contains("CB2;SB3;OFD=6;WT 1500", lines);
        Assert.Contains(lines, line => line.StartsWith("CB1;STS;", StringComparison.Ordinal) && line.EndsWith("CB4;OFD=0;CB2;CB3", StringComparison.Ordinal));
        Assert.Equal("CB4;OFD=0;CB2;CB3", lines[Array.IndexOf(lines, "MG \"DONE\"") - 1]);
    }

    private static MotionProgram Lines(JobMode mode, params int[] outputs) => new(MachineProfile.Default with { OperationOutputs = Air | Coolant }, default,
        [.. outputs.Select((on, index) => new MotionStroke(index, new(2000, 2000 * index), [new VectorSequence(new(2000, 2000 * index), 20000, [HeightBench.Line(new(2000, 2000 * index), new(12000, 2000 * index))])]) { Terms = new StrokeTerms(0, 0.0, 0.0) { Outputs = Air | Coolant, OutputsOn = on } })])
    { Style = mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous };

    /// <summary>The other outputs at each stroke, while the tool is on.</summary>
    private static IEnumerable<int> CutWith(SimulatedBench bench) =>
        bench.Controller.Record.Snapshot().Where(sample => (sample.Outputs & 1) != 0 && sample.A is > 2500 and < 11500).GroupBy(sample => sample.B).OrderBy(stroke => stroke.Key).Select(stroke => stroke.Select(sample => sample.Outputs & ~1).Distinct().Single());
}
