namespace Engraver.Galil.Programs.Generation;

/// <summary>A place that is planned slower than its feed, because the host cannot send its segments in time.</summary>
/// <param name="Speed">Planned, counts/s.</param>
/// <param name="Feed">As asked, counts/s.</param>
/// <param name="Entity">Drawing entity.</param>
internal readonly record struct SlowSending(double Speed, double Feed, int Entity);
