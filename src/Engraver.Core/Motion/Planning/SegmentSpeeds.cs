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
    public int FirstFor(double length, double acceleration) =>
        Math.Max(Second, Math.Min(First, 2 * (int)(Math.Sqrt((Exit * Exit) + (2.0 * acceleration * Math.Max(0.0, length - Rest(Exit, acceleration)))) / 2.0)));

    /// <summary>Length of a brake, counts. 0 where the speed is not above the other one.</summary>
    /// <param name="from">Speed before it, counts/s.</param>
    /// <param name="to">Speed after it.</param>
    /// <param name="acceleration">VD, counts/s2.</param>
    public static double BrakeOf(double from, double to, double acceleration) => from <= to ? 0.0 : (((from * from) - (to * to)) / (2.0 * acceleration)) + Rest(to, acceleration);

    /// <summary>The controller changes the speed sample by sample: the one in which a brake ends takes up to this much longer than the ramp. Before a sharp
    /// turn, which is passed at less than the change of one sample, it must be over, or the turn is passed several times too fast. A faster speed is
    /// exceeded by a small part of itself only.</summary>
    private static double Rest(double speed, double acceleration) =>
        speed < acceleration * PathLimits.Sample ? (speed * PathLimits.Sample) + (acceleration * PathLimits.Sample * PathLimits.Sample / 8.0) : 0.0;
}
