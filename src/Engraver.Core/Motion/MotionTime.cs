using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>Duration of a motion program from the trapezoids that a controller runs, each a whole number of its samples, and from the commands that are
/// exchanged while the machine is at rest.</summary>
/// <remarks>The time counts from the first rapid to the last settle, or to the end of the move to the finish of the program.</remarks>
public static class MotionTime
{
    /// <summary>The seconds by kind; 0 where nothing is cut.</summary>
    public static MotionTimes Calculate(MotionProgram program, CommandTimes commands) => ByStroke(program, commands).Total;

    /// <summary>The seconds of each stroke by kind, and those that belong to none.</summary>
    public static StrokeTimes ByStroke(MotionProgram program, CommandTimes commands)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(commands);
        if (program.Strokes.Count == 0) return new StrokeTimes([], default);
        var around = new MotionTimes(0.0, 0.0, commands.Loading(program) + (program.Profile.Spindle?.SpinUpSeconds ?? 0.0));
        var (strokes, at) = (new List<MotionTimes>(program.Strokes.Count), program.Start);
        if (program.Profile.Height is not null) around += ToolAt(at, on: false, null, program, commands); // it is raised from its present height
        foreach (var stroke in program.Strokes)
        {
            var times = Ready(at, stroke.Terms, commands) + RapidTo(stroke.Start, at, program, commands) + ToolAt(stroke.Start, on: true, stroke.Terms, program, commands);
            for (var i = 0; i < stroke.Sequences.Count; i++) times += Cut(stroke.Sequences[i], program, commands);
            at = stroke.Sequences[^1].End;
            strokes.Add(times + Dwell(at, stroke.Terms, commands) + ToolAt(at, on: false, stroke.Terms, program, commands));
        }

        return new StrokeTimes(strokes, program.Finish is { } finish ? around + RapidTo(finish, at, program, commands) : around);
    }

    /// <summary>A rapid in plan: X and Y.</summary>
    internal static MotionTimes RapidTo(CountsPoint target, CountsPoint from, MotionProgram program, CommandTimes commands)
    {
        var profile = program.Profile;
        double Seconds(MachineAxis axis, long to, long at) => Sampled(Math.Abs((double)to - at), commands.RapidSpeed(profile, axis), profile.RapidAcceleration(axis), commands);
        var moving = Math.Max(Seconds(profile.Axes.X, target.X, from.X), Seconds(profile.Axes.Y, target.Y, from.Y));
        return new MotionTimes(0.0, moving, commands.Rapid(from, target, moving, program));
    }

    internal static MotionTimes Cut(VectorSequence sequence, MotionProgram program, CommandTimes commands)
    {
        var moving = Sampled(SequenceProfile.SecondsOf(sequence, program.Profile), commands);
        return new MotionTimes(moving, 0.0, commands.Sequence(sequence, moving, program));
    }

    /// <summary>The wait before the machine moves to a stroke.</summary>
    internal static MotionTimes Ready(CountsPoint at, StrokeTerms? terms, CommandTimes commands) => terms is { ReadySeconds: > 0.0 and var seconds } ? new MotionTimes(0.0, 0.0, commands.Wait(at, seconds)) : default;

    /// <summary>The wait at the end of a stroke.</summary>
    internal static MotionTimes Dwell(CountsPoint at, StrokeTerms? terms, CommandTimes commands) => terms is { DwellSeconds: > 0.0 and var seconds } ? new MotionTimes(0.0, 0.0, commands.Wait(at, seconds)) : default;

    /// <summary>The tool is switched on or off, and waits before it moves; the moves of a tool axis count as rapids.</summary>
    /// <param name="terms">Of the stroke; null: as the profile states.</param>
    internal static MotionTimes ToolAt(CountsPoint at, bool on, StrokeTerms? terms, MotionProgram program, CommandTimes commands)
    {
        var moving = program.Profile.Axes.Z is { } z && program.Profile.Height is not null ? HeightSeconds(at.Z, on, terms, program.Profile, z, commands) : 0.0;
        var switching = commands.Tool(at, on, moving, program);
        return new MotionTimes(0.0, moving, switching + (on && terms is { PierceSeconds: > 0.0 and var seconds } ? commands.Wait(at, seconds) : 0.0));
    }

    private static double HeightSeconds(int height, bool on, StrokeTerms? terms, MachineProfile profile, MachineAxis z, CommandTimes commands)
    {
        double Move(double from, double to, double speed) => Sampled(Math.Abs(to - from), speed, profile.AccelerationCounts, commands);
        var (clearance, rapid) = (profile.ClearanceCounts, commands.RapidSpeed(profile, z));
        if (!on) return Move(height, clearance, rapid);
        var retract = profile.UpSign * Math.Max(profile.UpSign * profile.RetractCounts, profile.UpSign * height);
        return Move(clearance, retract, rapid) + Move(retract, height, terms?.PlungeSpeed ?? commands.PlungeSpeed(profile));
    }

    /// <summary>The trapezoid up to the sample in which it ends.</summary>
    private static double Sampled(double distance, double speed, double acceleration, CommandTimes commands) => Sampled(SpeedTrapezoid.Time(distance, speed, acceleration), commands);

    private static double Sampled(double seconds, CommandTimes commands) => Math.Ceiling(seconds / commands.Sample) * commands.Sample;
}
