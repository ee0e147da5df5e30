namespace Engraver.Simulator.Protocol;

/// <summary>One direction of a serial line in real time: a byte has arrived when its time on the wire has passed.</summary>
/// <param name="byteTime">Wall time of a byte as the line is now; zero for one that carries at once, as in virtual time, where the clock is advanced
/// instead.</param>
internal sealed class BytePacer(TimeProvider time, Func<TimeSpan> byteTime)
{
    private static readonly TimeSpan Shortest = TimeSpan.FromMilliseconds(1);
    private readonly long _start = time.GetTimestamp();
    private TimeSpan _free;

    /// <summary>Completes when so many more bytes have gone over the wire.</summary>
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
