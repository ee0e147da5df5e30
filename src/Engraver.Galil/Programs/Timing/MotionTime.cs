using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Galil.Programs.Timing;

/// <summary>How long a motion program takes by the trapezoids the controller runs (galil-dmc.md I, "Golden numbers for the profile"), each a whole number of samples,
/// and by the commands that are exchanged while the machine stands.</summary>
/// <remarks>Command times are those of Ethernet where no others are given. The time counts from the first rapid to the last settle, or to the end of the way to where the program finishes.</remarks>
public static class MotionTime
{
    /// <summary>Seconds of all kinds together.</summary>
    public static double Estimate(MotionProgram program) => Calculate(program).Total;

    /// <summary>The seconds by kind over Ethernet.</summary>
    public static MotionTimes Calculate(MotionProgram program) => Calculate(program, CommandTimes.Ethernet);

    /// <summary>The seconds by kind; nothing to cut takes no time.</summary>
    public static MotionTimes Calculate(MotionProgram program, CommandTimes commands)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(commands);
        if (program.Strokes.Count == 0) return default;
        var times = new MotionTimes(0.0, 0.0, commands.Loading(program));
        var at = program.Start;
        foreach (var stroke in program.Strokes)
        {
            times += RapidTo(stroke.Start, at, program, commands) + ToolAt(stroke.Start, program, commands);
            foreach (var sequence in stroke.Sequences) times += Cut(sequence, program, commands);
            at = stroke.Sequences[^1].End;
            times += ToolAt(at, program, commands);
        }

        return program.Finish is { } finish ? times + RapidTo(finish, at, program, commands) : times;
    }

    internal static MotionTimes RapidTo(CountsPoint target, CountsPoint from, MotionProgram program, CommandTimes commands)
    {
        var (x, y) = (Math.Abs((double)target.X - from.X), Math.Abs((double)target.Y - from.Y));
        var profile = program.Profile;
        var moving = Math.Max(Sampled(x, profile.RapidSpeedX, profile.AccelerationCounts), Sampled(y, profile.RapidSpeedY, profile.AccelerationCounts));
        return new MotionTimes(0.0, moving, commands.Rapid(from, target, moving, program));
    }

    internal static MotionTimes Cut(VectorSequence sequence, MotionProgram program, CommandTimes commands)
    {
        var moving = Sampled(sequence.Length, sequence.Speed, program.Profile.AccelerationCounts);
        return new MotionTimes(moving, 0.0, commands.Sequence(sequence, moving, program));
    }

    internal static MotionTimes ToolAt(CountsPoint at, MotionProgram program, CommandTimes commands) => new(0.0, 0.0, commands.Tool(at, program));

    /// <summary>The trapezoid up to the sample in which it ends.</summary>
    private static double Sampled(double distance, double speed, double acceleration) => Math.Ceiling(SpeedTrapezoid.Time(distance, speed, acceleration) / CommandTimes.Sample) * CommandTimes.Sample;
}
