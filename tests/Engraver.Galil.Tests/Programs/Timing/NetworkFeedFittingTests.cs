using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Jobs;

namespace Engraver.Galil.Tests.Programs.Timing;

/// <summary>A network that is slower than the plan assumes lowers the feed of the sequences that need it, and a warning states by how much.</summary>
public class NetworkFeedFittingTests
{
    /// <summary>60 counts take 3 ms at 20,000 counts/s, and a segment needs 1.08 exchanges.</summary>
    [Theory]
    [InlineData(0.0016, null)]
    [InlineData(0.0024, null)]
    [InlineData(0.0055555, 10000)]
    [InlineData(0.0277777, 2000)]
    public void A_long_sequence_is_no_faster_than_its_segments_can_be_sent(double exchange, int? speed)
    {
        var program = MotionPrograms.ShortLines(1500);

        var fit = NetworkFeedFitting.Create(program, exchange, null);

        Assert.Equal(speed ?? 20000, fit.Program.Strokes[0].Sequences[0].Speed, 4.0);
        if (speed is null) Assert.Empty(fit.Diagnostics);
        else Assert.Contains($"At 1200 mm/min the path needs 333. The feed is lowered in 1 of the vector sequences, to a minimum of {Math.Floor(speed.Value * 0.06)}", Assert.Single(fit.Diagnostics).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_sequence_that_is_in_the_buffer_before_it_starts_keeps_its_feed()
    {
        var program = MotionPrograms.ShortLines(400);

        Assert.Same(program, NetworkFeedFitting.Create(program, 0.1, null).Program);
    }

    /// <summary>The feed that is asked, not the one that an earlier limit left.</summary>
    [Fact]
    public void The_warning_states_the_feed_that_was_asked()
    {
        var program = MotionPrograms.ShortLines(1500);
        var slowed = program with { Strokes = [.. program.Strokes.Select(stroke => stroke with { Sequences = [.. stroke.Sequences.Select(sequence => sequence with { Feed = 40000 })] })] };

        Assert.Contains("At 2400 mm/min the path needs 667", Assert.Single(NetworkFeedFitting.Create(slowed, 0.0055555, null).Diagnostics).Message, StringComparison.Ordinal);
    }

    /// <summary>The limit holds for an override too: on a network that was measured to need 10 ms for an exchange, 60 counts need 10.8 ms.</summary>
    [Fact]
    public async Task An_override_does_not_exceed_what_the_measured_network_carries()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        session.ExchangeSeconds = 0.01;
        var program = NetworkFeedFitting.Create(MotionPrograms.ShortLines(700), 0.01, null).Program;
        var fastest = 0.0;
        var options = SimulatedBench.Job with { Strategy = JobMode.Stream.Strategy(), Control = new JobControl { FeedRatio = 2.0 } };

        var result = await JobRunner.RunAsync(program, session, options, new CancelWhen(now => (fastest = Math.Max(fastest, now.IsOnPath ? now.FeedRatio : 0.0)) < 0.0, () => { }), CancellationToken.None);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.InRange(fastest, 1.0, 1.05);
        Assert.InRange(result.Seconds, 700.0 * 60.0 / 5560.0, double.MaxValue);
    }

    [Fact]
    public async Task The_exchange_is_measured_on_the_connected_controller()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();

        Assert.InRange(await RoundTrip.MeasureAsync(session.Commands, session.Time, CancellationToken.None), 0.001, 0.0025);
    }

    /// <summary>A serial adapter that holds every answer back for some milliseconds.</summary>
    [Fact]
    public void A_slow_turnaround_of_a_serial_line_lowers_the_feed_further()
    {
        var program = MotionPrograms.ShortLines(1500);
        var line = new SerialLine(115200);

        var (usual, slow) = (LinkFeedFitting.Create(program, line, null), LinkFeedFitting.Create(program, line with { TurnaroundSeconds = 0.03 }, null));

        Assert.Empty(usual.Diagnostics);
        Assert.InRange(slow.Program.Strokes[0].Sequences[0].Speed, 4000, 19000);
        Assert.Single(slow.Diagnostics);
    }
}
