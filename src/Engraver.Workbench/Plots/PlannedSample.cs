namespace Engraver.Workbench.Plots;

/// <summary>A planned motion at one time.</summary>
/// <param name="Seconds">Since the start of the job.</param>
/// <param name="Path">Length of the path travelled, mm.</param>
/// <param name="Entity">Drawing entity that is cut or is next.</param>
/// <param name="Speed">mm/min.</param>
/// <param name="AccelerationX">mm/s2.</param>
/// <param name="AccelerationY">mm/s2.</param>
/// <param name="LinkLoad">Percent; NaN where the link has no limit.</param>
internal readonly record struct PlannedSample(double Seconds, double Path, int Entity, double Speed, double AccelerationX, double AccelerationY, double LinkLoad)
{
    public double LargestAcceleration => Math.Max(Math.Abs(AccelerationX), Math.Abs(AccelerationY));
}
