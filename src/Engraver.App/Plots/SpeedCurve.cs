using Engraver.Workbench.Playback;

namespace Engraver.App.Plots;

/// <summary>Planned speed over time, as many samples as a window can show.</summary>
/// <param name="TotalSeconds">Time of the end; the first sample is at 0.</param>
public sealed record SpeedCurve(double TotalSeconds, IReadOnlyList<SpeedSample> Samples)
{
    private const int MostSamples = 4000;

    /// <summary>mm/s.</summary>
    public double Peak { get; } = Samples.Count == 0 ? 0.0 : Samples.Max(sample => sample.Speed);

    public static SpeedCurve Of(PlannedMotion motion) => new(motion.DurationSeconds, Workbench.Playback.SpeedPlot.Of(motion, MostSamples));
}
