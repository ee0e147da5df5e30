using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Galil.Programs.Generation;

namespace Engraver.Galil.Programs.Timing;

/// <summary>Lowers the speeds of a motion program if the exchanges of a network take longer than the plan assumes (<see cref="FeedLimit"/>).</summary>
internal static class NetworkFeedFitting
{
    /// <param name="exchangeSeconds">Measured time from a command to its reply.</param>
    /// <param name="sourceOf">Position of an entity in the drawing's file; null if it is not known.</param>
    public static LinkFeedFit Create(MotionProgram program, double exchangeSeconds, Func<int, SourceRef>? sourceOf)
    {
        var perSegment = FeedLimit.ExchangesPerSegment * exchangeSeconds;
        if (perSegment <= FeedLimit.SecondsPerSegment) return new LinkFeedFit(program, []);
        var (count, worst) = (0, default((VectorSequence Wanted, int Speed, int Segment)?));
        VectorSequence Fit(VectorSequence sequence)
        {
            if (SlowestOf(sequence, perSegment) is not var (speed, segment)) return sequence;
            count++;
            if (worst is not { } other || (double)speed / Asked(sequence) < (double)other.Speed / Asked(other.Wanted)) worst = (sequence, speed, segment);
            return sequence.LimitedTo(speed);
        }

        var strokes = program.Strokes.Select(stroke => stroke with { Sequences = [.. stroke.Sequences.Select(Fit)] }).ToList();
        if (worst is not { } slowest) return new LinkFeedFit(program, []);
        string Feed(int countsPerSecond) => program.Profile.Scale.Coarser.LengthOf(60.0 * countsPerSecond).ToString("0.#", CultureInfo.InvariantCulture);
        string Number(double value) => value.ToString("0", CultureInfo.InvariantCulture);
        var warning = MotionRules.NetworkTooSlow.At(
            sourceOf?.Invoke(slowest.Wanted.Segments[slowest.Segment].EntityIndex) ?? default, (1000.0 * exchangeSeconds).ToString("0.#", CultureInfo.InvariantCulture), Number(1.0 / perSegment), Feed(Asked(slowest.Wanted)), Number(Asked(slowest.Wanted) / (slowest.Speed * perSegment)), Number(count), Feed(slowest.Speed));
        return new LinkFeedFit(program with { Strokes = strokes }, [warning]);
    }

    private static int Asked(VectorSequence sequence) => sequence.Feed ?? sequence.Speed;

    /// <summary>The lowest of the speeds at which the segments can be sent, among those that are planned faster; null where none is.</summary>
    /// <param name="perSegment">Time of a segment, seconds.</param>
    public static (int Speed, int Segment)? SlowestOf(VectorSequence sequence, double perSegment)
    {
        if (FeedLimit.Of([.. sequence.Segments.Select(segment => segment.Length)], perSegment) is not { } sent) return null;
        var slowest = default((int Speed, int Segment)?);
        for (var i = 0; i < sent.Length; i++)
        {
            if (sequence.SpeedOf(sequence.Segments[i]) > sent[i] && (slowest is not { } other || sent[i] < other.Speed)) slowest = (sent[i], i);
        }

        return slowest;
    }
}
