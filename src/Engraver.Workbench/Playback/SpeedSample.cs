namespace Engraver.Workbench.Playback;

/// <summary>A corner of the speed plot; between two of them the speed is a straight line over time.</summary>
/// <param name="Seconds">Since the job began.</param>
/// <param name="PathMm">Path of the tool so far, rapids included.</param>
/// <param name="Speed">mm/s.</param>
/// <param name="Cutting">False in rapids and standstills.</param>
public readonly record struct SpeedSample(double Seconds, double PathMm, double Speed, bool Cutting);
