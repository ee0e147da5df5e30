namespace Engraver.Galil.Programs;

/// <summary>How long a motion program takes by the trapezoids the controller runs (galil-dmc.md I, "Golden numbers for the profile"); command and polling times are not in it.</summary>
public static class MotionTime
{
    /// <summary>Seconds from the first rapid to the last settle.</summary>
    public static double Estimate(MotionProgram program)
    {
        var profile = program.Profile;
        var seconds = 0.0;
        var at = program.Start;
        foreach (var stroke in program.Strokes)
        {
            seconds += Math.Max(
                Trapezoid(Math.Abs((double)stroke.Start.X - at.X), profile.RapidSpeedX, profile.AccelerationCounts),
                Trapezoid(Math.Abs((double)stroke.Start.Y - at.Y), profile.RapidSpeedY, profile.AccelerationCounts));
            seconds += stroke.Sequences.Sum(sequence => Trapezoid(sequence.Length, sequence.Speed, profile.AccelerationCounts));
            seconds += 2.0 * profile.ToolSettleSeconds;
            at = stroke.Sequences[^1].End;
        }

        return seconds;
    }

    /// <summary>Seconds for a distance (counts) at a speed (counts/s) with the same acceleration and deceleration (counts/s2); a triangle when the distance is short.</summary>
    public static double Trapezoid(double distance, double speed, double acceleration) => distance >= speed * speed / acceleration
        ? (distance / speed) + (speed / acceleration)
        : 2.0 * Math.Sqrt(distance / acceleration);
}
