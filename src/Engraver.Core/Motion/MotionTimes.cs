namespace Engraver.Core.Motion;

/// <summary>The parts of a motion program's time, in seconds of the controller.</summary>
/// <param name="Cutting">In vector motion.</param>
/// <param name="Rapid">In moves between strokes, tool off.</param>
/// <param name="Dwell">At a standstill: tool settling, and the commands that must be exchanged before the machine moves again.</param>
public readonly record struct MotionTimes(double Cutting, double Rapid, double Dwell)
{
    public double Total => Cutting + Rapid + Dwell;

    /// <summary>The total under overrides, which change speeds but no dwells; ramps are short compared with the rest.</summary>
    /// <param name="feed">Factor of the feed in effect.</param>
    /// <param name="rapid">Factor of the rapid speed.</param>
    public double Under(double feed, double rapid) => (Cutting / feed) + (Rapid / rapid) + Dwell;

    public static MotionTimes operator +(MotionTimes left, MotionTimes right) =>
        new(left.Cutting + right.Cutting, left.Rapid + right.Rapid, left.Dwell + right.Dwell);
}
