using Engraver.Core.Motion;

namespace Engraver.Workbench.Playback;

/// <summary>Samples of the planned speed over time and path, for the palette of plots.</summary>
public static class SpeedPlot
{
    /// <summary>Corners of every ramp; for a job with too many corners, samples at equal times, to limit the cost of the plot.</summary>
    /// <param name="maxSamples">At least 2.</param>
    public static IReadOnlyList<SpeedSample> Sample(PlannedMotion motion, int maxSamples)
    {
        ArgumentNullException.ThrowIfNull(motion);
        ArgumentOutOfRangeException.ThrowIfLessThan(maxSamples, 2);
        List<double> corners = [.. Corners(motion).Take(maxSamples + 1)];
        var moments = corners.Count <= maxSamples ? corners : Even(motion.DurationSeconds, maxSamples);
        var samples = new List<SpeedSample>();
        var (path, last) = (0.0, motion.At(0.0));
        foreach (var seconds in moments)
        {
            var at = motion.At(seconds);
            path += (at.Speed + last.Speed) / 2.0 * (at.Seconds - last.Seconds);
            samples.Add(new SpeedSample(at.Seconds, path, at.Speed, at.Kind == MotionSpanKind.Cut));
            last = at;
        }

        return samples;
    }

    private static IEnumerable<double> Even(double duration, int count) => Enumerable.Range(0, count).Select(i => duration * i / (count - 1));

    private static IEnumerable<double> Corners(PlannedMotion motion)
    {
        foreach (var span in motion.Timeline.Spans)
        {
            yield return span.Start;
            if (span.Kind == MotionSpanKind.Dwell) continue;
            if (span.Kind == MotionSpanKind.Cut)
            {
                var profile = motion.ProfileOf(span.Stroke, span.Sequence);
                foreach (var change in profile.Changes.Skip(1).SkipLast(1)) yield return span.Start + profile.SecondsAt(change);
            }
            else
            {
                var axis = Longest(motion.Timeline.RapidOf(span));
                yield return span.Start + axis.RampSeconds;
                yield return span.Start + axis.Seconds - axis.RampSeconds;
            }

            yield return Math.BitDecrement(span.End);
        }

        yield return motion.DurationSeconds;
    }

    private static SpeedTrapezoid Longest(IReadOnlyList<SpeedTrapezoid> axes) => axes.MaxBy(axis => axis.Seconds);
}
