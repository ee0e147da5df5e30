namespace Engraver.Simulator.Protocol;

/// <summary>One direction of a serial line in real time: a byte has arrived when its transmission time has passed.</summary>
/// <param name="byteTime">Present wall time of a byte on the line; zero for a line that transmits at once, as in virtual time, where the clock is advanced
/// instead.</param>
internal sealed class BytePacer(TimeProvider time, Func<TimeSpan> byteTime)
{
    private static readonly TimeSpan Shortest = TimeSpan.FromMilliseconds(1);
    private readonly long _start = time.GetTimestamp();
    private TimeSpan _free;

    /// <summary>Completes when the given number of further bytes has been transmitted.</summary>
    public async Task PassAsync(int bytes, CancellationToken cancellation)
    {
        var each = byteTime();
        if (each <= TimeSpan.Zero) return;
        var now = time.GetElapsedTime(_start);
        _free = (_free > now ? _free : now) + (each * bytes);
        while (_free - time.GetElapsedTime(_start) is var rest && rest > TimeSpan.Zero)
        {
            await Task.Delay(rest > Shortest ? rest : Shortest, time, cancellation).ConfigureAwait(false);
        }
    }
}
