using Engraver.Workbench.Playback;

namespace Engraver.App.Plots;

/// <summary>Planned speed over time, with as many samples as a window can show.</summary>
/// <param name="TotalSeconds">Time of the last sample; the first is at 0.</param>
public sealed record SpeedCurve(double TotalSeconds, IReadOnlyList<SpeedSample> Samples)
{
    private const int MaxSamples = 4000;

    /// <summary>mm/s.</summary>
    public double Peak { get; } = Samples.Count == 0 ? 0.0 : Samples.Max(sample => sample.Speed);

    public static SpeedCurve From(PlannedMotion motion) => new(motion.DurationSeconds, Workbench.Playback.SpeedPlot.Sample(motion, MaxSamples));
}
