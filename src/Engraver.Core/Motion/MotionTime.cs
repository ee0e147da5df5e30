using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>How long a motion program takes by the trapezoids that a controller runs, each a whole number of its samples, and by the commands that are exchanged while the machine stands.</summary>
/// <remarks>The time counts from the first rapid to the last settle, or to the end of the way to where the program finishes.</remarks>
public static class MotionTime
{
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
        var (speeds, acceleration) = (commands.RapidSpeeds(program.Profile), program.Profile.AccelerationCounts);
        var moving = Math.Max(Sampled(x, speeds.X, acceleration, commands), Sampled(y, speeds.Y, acceleration, commands));
        return new MotionTimes(0.0, moving, commands.Rapid(from, target, moving, program));
    }

    internal static MotionTimes Cut(VectorSequence sequence, MotionProgram program, CommandTimes commands)
    {
        var moving = Sampled(sequence.Length, sequence.Speed, program.Profile.AccelerationCounts, commands);
        return new MotionTimes(moving, 0.0, commands.Sequence(sequence, moving, program));
    }

    internal static MotionTimes ToolAt(CountsPoint at, MotionProgram program, CommandTimes commands) => new(0.0, 0.0, commands.Tool(at, program));

    /// <summary>The trapezoid up to the sample in which it ends.</summary>
    private static double Sampled(double distance, double speed, double acceleration, CommandTimes commands) => Math.Ceiling(SpeedTrapezoid.Time(distance, speed, acceleration) / commands.Sample) * commands.Sample;
}
