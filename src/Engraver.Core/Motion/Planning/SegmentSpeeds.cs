namespace Engraver.Core.Motion.Planning;

/// <summary>The commands of one planned segment.</summary>
/// <param name="First">Speed from its start, even counts/s.</param>
/// <param name="Second">Speed from <paramref name="Braking"/> counts before its end; 0: the first one up to the end.</param>
/// <param name="Braking">Counts.</param>
/// <param name="Exit">Speed at its end, counts/s.</param>
public readonly record struct SegmentSpeeds(int First, int Second, double Braking, double Exit)
{
    /// <summary>The first speed, lowered so that the brake fits the part in which it takes place: where a brake ends late, the path turns too fast; where it
    /// ends early, the machine creeps to the end of the part.</summary>
    /// <param name="length">Length of that part, counts.</param>
    /// <param name="acceleration">VD, counts/s2.</param>
    public int FirstFor(double length, double acceleration) => Math.Max(Second, Math.Min(First, 2 * (int)(Math.Sqrt((Exit * Exit) + (2.0 * acceleration * length)) / 2.0)));
}
