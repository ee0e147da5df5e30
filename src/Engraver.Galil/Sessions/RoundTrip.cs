using Engraver.Core.Machines;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Measures how long an exchange with the controller takes.</summary>
internal static class RoundTrip
{
    /// <summary>One of them may be delayed by this computer; the median of an odd number is not.</summary>
    private const int Exchanges = 9;

    /// <returns>Median of several exchanges, seconds: on a serial line without the time of the bytes.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    public static async Task<double> MeasureAsync(CommandChannel channel, TimeProvider time, CancellationToken cancellation)
    {
        var (command, bytes) = channel.Line is null ? ("MG 0", 0) : ("", 2); // a line that is answered by a prompt alone
        var seconds = new double[Exchanges];
        for (var i = 0; i < Exchanges; i++)
        {
            var begun = time.GetTimestamp();
            await channel.SendAsync(command, cancellation).ConfigureAwait(false);
            seconds[i] = time.GetElapsedTime(begun).TotalSeconds;
        }

        Array.Sort(seconds);
        return Math.Max(0.0, seconds[Exchanges / 2] - (channel.Line?.Time(bytes).TotalSeconds ?? 0.0));
    }
}
