using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Timing;

/// <summary>Computes the speed at which a serial line can stream a vector sequence: the buffer is full when the machine starts, and from then on every
/// segment must arrive in time (galil-dmc.md A.4, B.7).</summary>
public static class LinkFeedLimit
{
    /// <summary>Segments between two readings of the counter when few are left to execute; a reading takes as long as seven segments.</summary>
    public const int SegmentsBetweenPolls = 64;

    /// <summary>Buffer places in use; the stream keeps a few free.</summary>
    internal const int Places = DmcLimits.SegmentBuffer - 5;

    /// <summary>Bytes of a reading of the path and its reply.</summary>
    private const int PollBytes = 100;

    /// <summary>Bytes of separator and prompt. The prompts take time although the line is full duplex, because the echo fills the other direction
    /// too.</summary>
    private const int FrameBytes = 2;

    /// <summary>Most segments between two readings of the counter, and their longest time, seconds: later the operator would see an old position.</summary>
    private const int MostSegments = 256;
    private const double MostSeconds = 2.0;
    private const int UsualSegmentBytes = 16;

    /// <summary>Factor on the time of a segment for polls, heartbeats and long numbers in replies; generous, because a buffer that runs dry is worse than a
    /// slow cut.</summary>
    private const double Overhead = 1.2;

    /// <summary>Delay between detecting that few segments are left and the command reaching the controller: four readings of the path, seconds.</summary>
    public static double ReactionSeconds(SerialLine line)
    {
        ArgumentNullException.ThrowIfNull(line);
        return 4.0 * PollBytes * line.ByteSeconds;
    }

    /// <summary>Segments between two readings of the counter while many are left to execute.</summary>
    public static int MostBetweenPolls(SerialLine line)
    {
        ArgumentNullException.ThrowIfNull(line);
        return Math.Clamp((int)(MostSeconds / line.Time(UsualSegmentBytes).TotalSeconds), SegmentsBetweenPolls, MostSegments);
    }

    /// <summary>The sequence's own speed, or the highest even one at which every segment is in the buffer in time (counts/s).</summary>
    /// <param name="acceleration">VA and VD, counts/s2.</param>
    public static int FastestSpeed(VectorSequence sequence, SerialLine line, int acceleration)
    {
        ArgumentNullException.ThrowIfNull(sequence);
        ArgumentNullException.ThrowIfNull(line);
        if (sequence.Segments.Count <= Places) return sequence.Speed;
        var costs = Costs(sequence, line);
        var latency = PollBytes * line.ByteSeconds;
        bool IsInTime(int speed) => IsFedInTime(sequence.Segments, costs, speed, latency, 2.0 * (((double)speed / acceleration) + ReactionSeconds(line)));
        return IsInTime(sequence.Speed) ? sequence.Speed : 2 * LargestHalf(sequence.Speed / 2, half => IsInTime(2 * half));
    }

    /// <summary>Segments per second needed by the densest full buffer of the sequence at its speed, and the number that the line can transmit.</summary>
    public static (double Needed, double Carried) Rates(VectorSequence sequence, SerialLine line)
    {
        ArgumentNullException.ThrowIfNull(sequence);
        ArgumentNullException.ThrowIfNull(line);
        var costs = Costs(sequence, line);
        var window = Math.Min(DmcLimits.SegmentBuffer, costs.Length);
        var (length, time) = (0.0, 0.0);
        var (shortest, timeThere) = (double.PositiveInfinity, 0.0);
        for (var i = 0; i < costs.Length; i++)
        {
            length += sequence.Segments[i].Length - (i >= window ? sequence.Segments[i - window].Length : 0.0);
            time += costs[i] - (i >= window ? costs[i - window] : 0.0);
            if (i >= window - 1 && length < shortest) (shortest, timeThere) = (length, time);
        }

        return (window * sequence.Speed / shortest, window / timeThere);
    }

    /// <summary>Transmission time of each segment, seconds: its bytes, and its share of the frame of a line of segments of its length.</summary>
    private static double[] Costs(VectorSequence sequence, SerialLine line)
    {
        var room = StreamLines.Room(line) + 1;
        return [.. DmcFormat.Commands(sequence, s_anyAxes).Select(command => (Overhead * (command.Length + FrameBytes) * line.ByteSeconds) + (line.TurnaroundSeconds / Math.Max(1, room / (command.Length + 1))))];
    }

    /// <summary>Only the length of a command matters, not its axis letters.</summary>
    private static readonly MachineAxes s_anyAxes = MachineAxes.Default with { Z = new MachineAxis('C', 1.0) };

    /// <summary>Simulates the sending, each segment as soon as the previous one is sent and a place is free, and tests that each arrives
    /// <paramref name="margin"/> before the path needs it.</summary>
    /// <remarks>Assumes full speed from the start; the actual ramp gives more time.</remarks>
    private static bool IsFedInTime(IReadOnlyList<VectorSegment> segments, double[] costs, int speed, double latency, double margin)
    {
        var (sent, freed, needed) = (0.0, 0.0, 0.0);
        for (var i = 0; i < Places; i++) needed += segments[i].Length / speed;
        for (var i = Places; i < segments.Count; i++)
        {
            freed += segments[i - Places].Length / speed;
            sent = Math.Max(sent, freed + latency) + costs[i];
            if (sent + margin > needed) return false;
            needed += segments[i].Length / speed;
        }

        return true;
    }

    /// <summary>The largest whole number up to <paramref name="most"/> for which the condition is true; at least 1. It is true for every smaller
    /// number.</summary>
    private static int LargestHalf(int most, Func<int, bool> holds)
    {
        var (low, high) = (DmcLimits.SlowestSpeed / 2, most);
        while (low < high)
        {
            var middle = (int)(((long)low + high + 1) / 2);
            if (holds(middle)) low = middle;
            else high = middle - 1;
        }

        return low;
    }
}
