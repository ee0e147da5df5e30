using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Timing;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Tests.Jobs.Holds;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>Strokes whose operations state a plunge feed and waits, checked by the record of the motors.</summary>
public class StrokeTermsTests
{
    private const double Pierce = 7.0; // longer than a job or its watchdog waits for progress

    public static TheoryData<JobMode> Modes => [JobMode.Stream, JobMode.Calls, JobMode.Program];

    /// <summary>The profile plunges with 3.2 counts a sample, the first stroke with 1.6 and the last with 6.4.</summary>
    [Theory]
    [MemberData(nameof(Modes))]
    public async Task Each_stroke_plunges_at_its_own_speed_and_waits_before_it_moves_and_before_it_is_left(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var part = HeightBench.Part(style: mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);
        var program = part with { Strokes = [part.Strokes[0] with { Terms = new StrokeTerms(1600, 0.5, 0.0) }, part.Strokes[1], part.Strokes[2] with { Terms = new StrokeTerms(6400, 0.0, 0.75) }] };

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.Equal([2, 4, 7], program.Strokes.Select(stroke => FastestFall(bench, stroke.Start)));
        Assert.Equal([(true, false), (false, false), (false, true)], program.Strokes.Select(stroke => (SamplesAt(bench, stroke.Start) >= 500, SamplesAt(bench, stroke.Sequences[^1].End) >= 750)));
        Assert.Equal(JobTime.Estimate(program, null, mode).Total, result.Seconds, 0.05 * result.Seconds);
        Assert.InRange(JobTime.Estimate(program, null, mode).Total - JobTime.Estimate(part, null, mode).Total, 1.1, 1.5);
        Assert.Equal(MotionTime.Calculate(program, DmcTimes.Ethernet).Total, MotionTimeline.From(program, DmcTimes.Ethernet, CancellationToken.None).Seconds + program.Profile.Spindle!.SpinUpSeconds, 6);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_beam_is_on_before_it_moves_for_longer_than_a_standstill_is_allowed(JobMode mode)
    {
        await using var bench = new SimulatedBench();

        var result = await bench.RunAsync(Line(mode, Pierce), SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal((JobOutcome.Complete, "Done: 1 segment."), (result.Outcome, result.Message));
        Assert.InRange(LastWait(bench), 7100, 7500);
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task After_a_hold_during_the_wait_the_beam_is_on_for_the_whole_wait_again(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var operators = new HoldingOperator(bench, progress => progress.Seconds > 1.0, 1.0);

        var result = await bench.RunAsync(Line(mode, 3.0), SimulatedBench.Job with { Strategy = mode.Strategy(), Control = operators.Control }, operators);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        var (from, to) = Assert.Single(operators.Held);
        Assert.InRange(LastWait(bench), 3100, 3600);
        Assert.All(bench.Controller.Record.Snapshot().Where(sample => sample.Sample > from && sample.Sample < to), sample => Assert.Equal(0, sample.Outputs));
        if (mode != JobMode.Program) Assert.InRange(from, 1000, 2500); // a program in the controller completes its wait
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_stop_during_the_wait_ends_it_with_the_beam_off(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();

        var result = await bench.RunAsync(Line(mode, Pierce), SimulatedBench.Job with { Strategy = mode.Strategy() }, new CancelWhen(progress => progress.Seconds > 1.5, stop.Cancel), stop.Token);

        Assert.Equal((JobOutcome.Stopped, 0), (result.Outcome, bench.Last.Outputs));
        Assert.DoesNotContain(bench.Controller.Record.Snapshot(), sample => sample.A > 2000);
    }

    [Theory]
    [InlineData(MotionStyle.Continuous)]
    [InlineData(MotionStyle.Calls)]
    public void A_posted_program_states_plunge_feeds_and_waits_only_where_a_stroke_does(MotionStyle style)
    {
        var part = HeightBench.Part(style: style);
        var program = part with { Strokes = [part.Strokes[0], part.Strokes[1] with { Terms = new StrokeTerms(1600, 0.25, 0.0) }, part.Strokes[2] with { Terms = new StrokeTerms(3200, 0.0, 0.75) }] };
        string Text(MotionProgram of) => (style == MotionStyle.Calls ? DmcPost.Calls(of, DmcPostOptions.Default) : DmcPost.Sequences(of, DmcPostOptions.Default)).Text;

        Assert.DoesNotContain("zf", Text(part), StringComparison.Ordinal);
        Assert.DoesNotContain("zf", Text(part with { Strokes = [part.Strokes[0] with { Terms = new StrokeTerms(3200, 0.5, 0.0) }] }), StringComparison.Ordinal);
        Assert.Equal(["zf=3200", "zf=1600", "zf=3200"], Text(program).Split('\n', ';').Where(statement => statement.StartsWith("zf=", StringComparison.Ordinal)));
        Assert.Contains("JS#DOWN;WT 250", Text(program), StringComparison.Ordinal);
        Assert.Contains("WT 750;JS#UP", Text(program), StringComparison.Ordinal);
        Assert.Contains("SPC=zf;PAC=z", Text(program), StringComparison.Ordinal);
    }

    /// <summary>A part that was divided is pierced again, and waits only at its end.</summary>
    [Fact]
    public void A_stroke_that_is_divided_keeps_its_terms()
    {
        var stroke = HeightBench.Part().Strokes[1] with { Terms = new StrokeTerms(1600, 0.5, 0.75) };

        var (first, tail) = StrokeCut.Before(stroke, 3);

        Assert.Equal((new StrokeTerms(1600, 0.5, 0.0), new StrokeTerms(1600, 0.5, 0.75)), (first.Terms!, tail.Terms!));
        Assert.Equal((first.Sequences[^1].End, stroke.Index), (tail.Start, tail.Index));
    }

    private static MotionProgram Line(JobMode mode, double pierce) => new(MachineProfile.Default, default,
        [new MotionStroke(0, new(2000, 0), [new VectorSequence(new(2000, 0), 20000, [HeightBench.Line(new(2000, 0), new(6000, 0))])]) { Terms = new StrokeTerms(0, pierce, 0.0) }]) { Style = mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous };

    /// <summary>Samples from the last time the output was switched on to the next change of position.</summary>
    private static long LastWait(SimulatedBench bench)
    {
        var record = bench.Controller.Record.Snapshot();
        var on = record.Zip(record.Skip(1)).Last(pair => pair is { First.Outputs: 0, Second.Outputs: 1 }).Second;
        return record.First(sample => sample.Sample > on.Sample && sample.A != on.A).Sample - on.Sample;
    }

    /// <summary>Counts per sample, below the retract height and above the start of a stroke.</summary>
    private static int FastestFall(SimulatedBench bench, CountsPoint start)
    {
        var record = bench.Controller.Record.Snapshot();
        return record.Zip(record.Skip(1)).Where(pair => (pair.First.A, pair.First.B, pair.Second.A, pair.Second.B) == (start.X, start.Y, start.X, start.Y) && pair.First.C <= HeightBench.Retract && pair.Second.C >= start.Z).Max(pair => pair.First.C - pair.Second.C);
    }

    /// <summary>Samples without a motion at a place.</summary>
    private static long SamplesAt(SimulatedBench bench, CountsPoint place)
    {
        var record = bench.Controller.Record.Snapshot();
        return record.Zip(record.Skip(1)).Where(pair => (pair.First.A, pair.First.B, pair.First.C) == (place.X, place.Y, place.Z)).Select(pair => pair.Second.Sample - pair.First.Sample).DefaultIfEmpty().Max();
    }
}
