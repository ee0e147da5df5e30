using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>How many of the exchanges over a network are segments while a path is streamed.</summary>
public class NetworkStreamTests
{
    private const int Segments = 6000;

    /// <summary>One exchange over a network (galil-dmc.md A.4).</summary>
    private const double ExchangeSeconds = 0.0016;

    /// <summary>Compared with a sender that has one command outstanding and neither polls nor sends heartbeats. The path needs a little more than the link
    /// carries: the buffer is neither full nor empty.</summary>
    [Theory]
    [InlineData(31)]
    [InlineData(24)]
    public async Task The_exchanges_are_segments(int step)
    {
        await using var bench = new SimulatedBench();
        var sent = default(double?);
        var from = default(double?);
        var watch = new CancelWhen(
            now =>
            {
                if (now.SegmentsSent > 0) from ??= now.Seconds - (now.SegmentsSent * ExchangeSeconds);
                return now.SegmentsSent == Segments;
            },
            () => sent ??= bench.Controller.Status.Sample);

        var result = await bench.RunAsync(MotionPrograms.ShortLines(Segments, step), SimulatedBench.Job with { Strategy = JobMode.Stream.Strategy() }, watch);

        Assert.Equal((JobOutcome.Complete, Segments, 0), (result.Outcome, result.SegmentsExecuted, result.Underruns));
        var took = (sent!.Value / 1000.0) - from!.Value;
        Assert.True(Segments * ExchangeSeconds >= 0.92 * took, $"{Segments * ExchangeSeconds / took:0.000} of the exchanges");
    }
}
