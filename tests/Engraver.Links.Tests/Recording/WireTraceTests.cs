using Engraver.Links.Recording;
using Engraver.TestKit;

namespace Engraver.Links.Tests.Recording;

/// <summary>A trace never delays what it records: a full disk or a reader that has stopped reading ends only the trace.</summary>
public class WireTraceTests
{
    private readonly ManualTimeProvider _time = new();

    [Fact]
    public async Task A_trace_on_a_full_disk_ends_and_states_the_reason()
    {
        if (OperatingSystem.IsWindows()) return; // no device is always full there
        var trace = new WireTrace(new StreamWriter("/dev/full") { AutoFlush = true }, _time);

        trace.Write("A", '>', "STS");
        await trace.CloseAsync(CancellationToken.None);

        Assert.Contains("the disk is full", trace.Failure, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_trace_whose_reader_has_stopped_reading_is_given_up_after_the_operators_stop()
    {
        using var stalled = new StalledWriter();
        var trace = new WireTrace(stalled, _time);
        using var stop = new CancellationTokenSource();

        trace.Write("A", '>', "STS");
        var closing = trace.CloseAsync(stop.Token);
        Assert.False(closing.IsCompleted); // without the operator's stop the reader has unlimited time
        await stop.CancelAsync();
        while (!closing.IsCompleted)
        {
            _time.Advance(WireTrace.FlushTimeout);
            await Task.Yield();
        }

        await closing;
        Assert.Contains("stopped reading", trace.Failure, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_trace_whose_reader_does_not_keep_up_ends_and_says_so()
    {
        var stalled = new StalledWriter();
        var trace = new WireTrace(stalled, _time);
        for (var line = 0; line <= WireTrace.MaxWaiting + 1; line++) trace.Write("A", '>', "STS");
        await stalled.DisposeAsync();
        await trace.CloseAsync(CancellationToken.None);

        Assert.Contains("fast enough", trace.Failure, StringComparison.Ordinal);
    }
}
