using Engraver.Core.Machines;
using Engraver.Galil.Programs.Timing;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Galil.Tests.Programs.Timing;

/// <summary>The capacity of a serial line.</summary>
public class LinkFeedLimitTests
{
    private const int Acceleration = 256000;

    /// <summary>Up to 1500 lines of 1 to 183 counts, in runs of short and of long ones, at 2000 to 40000 counts/s.</summary>
    internal static Arbitrary<VectorSequence> Sequences => (
        from runs in Gen.Choose(1, 5).SelectMany(count => Gen.ArrayOf(Gen.Two(Gen.Choose(1, 300)), count))
        from scale in Gen.Choose(1, 3)
        from speed in Gen.Choose(1000, 20000)
        select Sequence(2 * speed, [.. runs.SelectMany(run => Enumerable.Repeat(scale * (1 + (run.Item2 / 5)), run.Item1))])).ToArbitrary();

    private static Arbitrary<SerialLine> Lines => Gen.Elements(SerialLine.Rates.Select(rate => new SerialLine(rate))).ToArbitrary();

    [Property]
    public Property The_feed_is_never_raised_and_what_is_fit_stays_as_it_is() => Prop.ForAll(Sequences, Lines, (sequence, line) =>
    {
        var speed = LinkFeedLimit.FastestSpeed(sequence, line, Acceleration);
        return speed >= 2 && speed % 2 == 0 && speed <= sequence.Speed && LinkFeedLimit.FastestSpeed(sequence with { Speed = speed }, line, Acceleration) == speed;
    });

    [Property]
    public Property A_faster_line_never_carries_less() => Prop.ForAll(Sequences, sequence =>
    {
        var speeds = SerialLine.Rates.Select(rate => LinkFeedLimit.FastestSpeed(sequence, new SerialLine(rate), Acceleration)).ToList();
        return speeds.SequenceEqual(speeds.Order());
    });

    [Fact]
    public void What_the_buffer_holds_is_cut_at_full_feed_over_any_line() =>
        Assert.Equal(20000, LinkFeedLimit.FastestSpeed(Sequence(20000, [.. Enumerable.Repeat(2, 506)]), new SerialLine(1200), Acceleration));

    [Fact]
    public void A_dense_run_within_the_buffer_is_carried_by_what_stands_around_it()
    {
        int[] lengths = [.. Enumerable.Repeat(2000, 600), .. Enumerable.Repeat(20, 200), .. Enumerable.Repeat(2000, 600)];

        Assert.Equal(20000, LinkFeedLimit.FastestSpeed(Sequence(20000, lengths), new SerialLine(19200), Acceleration));
    }

    [Fact]
    public void The_warning_says_what_is_needed_what_is_carried_and_how_slow_it_gets()
    {
        var sequence = Sequence(20000, [.. Enumerable.Repeat(100, 2000)]);
        var program = new MotionProgram(MachineProfile.Default, default, [new MotionStroke(0, default, [sequence])]);

        var fit = LinkFeedFitting.Create(program, new SerialLine(19200), null);

        var finding = Assert.Single(fit.Diagnostics);
        Assert.Matches("^At full feed, the path needs 200 segments per second, but 19200 baud can transfer [0-9]{2,3}\\. The feed is lowered in 1 of the vector sequences, to a minimum of [0-9.]+ instead of 1200 mm/min", finding.Message);
        Assert.Equal(program.SegmentCount, fit.Program.SegmentCount);
        Assert.Empty(LinkFeedFitting.Create(fit.Program, new SerialLine(19200), null).Diagnostics);
    }

    private static VectorSequence Sequence(int speed, int[] lengths)
    {
        var x = 0;
        return new VectorSequence(default, speed, [.. lengths.Select((length, i) => new VectorSegment(VectorSegmentKind.Line, new(x += length, 0), 0, 0, 0, i, length))]);
    }
}
