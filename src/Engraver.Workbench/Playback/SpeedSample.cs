namespace Engraver.Workbench.Playback;

/// <summary>A corner of the speed plot; between two corners the speed is linear in time.</summary>
/// <param name="Seconds">Since the start of the job.</param>
/// <param name="PathMm">Path of the tool so far, rapids included.</param>
/// <param name="Speed">mm/s.</param>
/// <param name="Cutting">False in rapids and standstills.</param>
public readonly record struct SpeedSample(double Seconds, double PathMm, double Speed, bool Cutting);
