using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Timing;

/// <summary>Lowers the speeds of a motion program if a serial line is too slow to stream it.</summary>
public static class LinkFeedFitting
{
    /// <param name="sourceOf">Position of an entity in the drawing's file; null if it is not known.</param>
    public static LinkFeedFit Create(MotionProgram program, SerialLine line, Func<int, SourceRef>? sourceOf)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(line);
        var strokes = program.Strokes
            .Select(stroke => stroke with { Sequences = [.. stroke.Sequences.Select(sequence => sequence.LimitedTo(LinkFeedLimit.FastestSpeed(sequence, line, sequence.AccelerationOn(program.Profile))))] })
            .ToList();
        var lowered = program.Strokes.SelectMany(stroke => stroke.Sequences)
            .Zip(strokes.SelectMany(stroke => stroke.Sequences), (wanted, fit) => (Wanted: wanted, Fit: fit))
            .Where(pair => pair.Fit.Speed < pair.Wanted.Speed)
            .ToList();
        if (lowered.Count == 0) return new LinkFeedFit(program, []);
        var (worst, slowest) = lowered.MinBy(pair => (double)pair.Fit.Speed / pair.Wanted.Speed);
        return new LinkFeedFit(program with { Strokes = strokes }, [Warning(program, line, lowered.Count, worst, slowest.Speed, sourceOf)]);
    }

    private static Diagnostic Warning(MotionProgram program, SerialLine line, int lowered, VectorSequence worst, int speed, Func<int, SourceRef>? sourceOf)
    {
        var (needed, carried) = LinkFeedLimit.Rates(worst, line);
        var asked = worst.Feed ?? worst.Speed;
        var scale = program.Profile.Scale.Coarser; // as a feed becomes a vector speed
        string Number(double value) => value.ToString("0", CultureInfo.InvariantCulture);
        string Feed(int countsPerSecond) => scale.LengthOf(60.0 * countsPerSecond).ToString("0.#", CultureInfo.InvariantCulture);
        return MotionRules.WireTooSlow.At(
            sourceOf?.Invoke(worst.Segments[0].EntityIndex) ?? default, Number(needed * asked / worst.Speed), Number(line.Baud), Number(carried), Number(lowered), Feed(speed), Feed(asked));
    }
}
