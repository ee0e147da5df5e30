namespace Engraver.Links.Serial;

/// <summary>Waits until a device has sent its bytes.</summary>
internal static class SerialDrain
{
    private static readonly TimeSpan s_pollInterval = TimeSpan.FromMilliseconds(10);

    /// <param name="unsent">Number of accepted bytes that are not sent yet.</param>
    /// <param name="timeout">Time without a sent byte after which the link counts as lost.</param>
    /// <exception cref="IOException">No byte was sent within the time-out.</exception>
    public static async Task WaitAsync(Func<int> unsent, TimeSpan timeout, TimeProvider time, CancellationToken cancellation)
    {
        var (least, since) = (int.MaxValue, time.GetTimestamp());
        while (unsent() is > 0 and var rest)
        {
            if (rest < least) (least, since) = (rest, time.GetTimestamp());
            else if (time.GetElapsedTime(since) > timeout) throw NothingAccepted(timeout, null);
            await Task.Delay(s_pollInterval, time, cancellation).ConfigureAwait(false);
        }
    }

    /// <summary>The failure of a line that accepts nothing.</summary>
    public static IOException NothingAccepted(TimeSpan timeout, Exception? cause) => new(Wording.Get("SerialLink.NothingAccepted", timeout.TotalSeconds), cause);
}
