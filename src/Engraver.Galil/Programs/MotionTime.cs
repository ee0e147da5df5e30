namespace Engraver.Galil.Programs;

/// <summary>How long a motion program takes by the trapezoids the controller runs (galil-dmc.md I, "Golden numbers for the profile"), each a whole number of samples,
/// and by the commands that are exchanged while the machine stands.</summary>
/// <remarks>Command times are those of Ethernet. The time counts from the first rapid to the last settle.</remarks>
public static class MotionTime
{
    /// <summary>One command and its reply over Ethernet (galil-dmc.md A.4).</summary>
    private const double SecondsPerCommand = 0.0016;

    /// <summary>One statement of a program in the controller (galil-dmc.md A.4).</summary>
    private const double SecondsPerStatement = 0.0005;

    /// <summary>The nominal sample (TM 1000); every motion ends on one.</summary>
    private const double Sample = 0.001;

    /// <summary>TIME counts 1024 in a second on hardware (galil-dmc.md C), and the settle is waited for by TIME.</summary>
    private const double SettleSamplesPerSecond = 1024.0;

    /// <summary>An end is noticed by the next poll, half a command later on average.</summary>
    private const double NoticeSeconds = SecondsPerCommand / 2.0;

    /// <summary>Poll before a rapid, SP and PA of an axis that moves, BG.</summary>
    private const int RapidCommands = 2;
    private const int RapidCommandsOfAxis = 2;

    /// <summary>SB or CB, and the poll from which the settle counts.</summary>
    private const int ToolCommands = 2;

    /// <summary>A poll, CSS, VM, VS, VA, VD, VR, the question for free places, VE and BGS.</summary>
    private const int SequenceCommands = 10;

    /// <summary>The stream begins to move when so much motion is buffered; what follows is sent meanwhile.</summary>
    private const double SecondsBufferedAtStart = 1.0;

    /// <summary>A poll, the arguments and go.</summary>
    private const int CallCommands = 3;

    /// <summary>Server loop, dispatch and subprogram of one call, its WT 2 included.</summary>
    private const int CallStatements = 26;

    /// <summary>Seconds of all kinds together.</summary>
    public static double Estimate(MotionProgram program) => Of(program).Total;

    /// <summary>The seconds by kind; nothing to cut takes no time.</summary>
    public static MotionTimes Of(MotionProgram program)
    {
        var times = default(MotionTimes);
        var at = program.Start;
        foreach (var stroke in program.Strokes)
        {
            times += RapidTo(stroke.Start, at, program);
            foreach (var sequence in stroke.Sequences) times += Cut(sequence, program);
            times += new MotionTimes(0.0, 0.0, 2.0 * ToolSeconds(program.Profile.ToolSettleSeconds));
            at = stroke.Sequences[^1].End;
        }

        return times;
    }

    /// <summary>Seconds for a distance (counts) at a speed (counts/s) with the same acceleration and deceleration (counts/s2); a triangle when the distance is short.</summary>
    public static double Trapezoid(double distance, double speed, double acceleration) => distance >= speed * speed / acceleration
        ? (distance / speed) + (speed / acceleration)
        : 2.0 * Math.Sqrt(distance / acceleration);

    internal static MotionTimes RapidTo(CountsPoint target, CountsPoint from, MotionProgram program)
    {
        var (x, y) = (Math.Abs((double)target.X - from.X), Math.Abs((double)target.Y - from.Y));
        if (x == 0.0 && y == 0.0) return new MotionTimes(0.0, 0.0, SecondsPerCommand);
        var profile = program.Profile;
        var moving = Math.Max(Sampled(x, profile.RapidSpeedX, profile.AccelerationCounts), Sampled(y, profile.RapidSpeedY, profile.AccelerationCounts));
        var commands = RapidCommands + ((x > 0.0 ? RapidCommandsOfAxis : 0) + (y > 0.0 ? RapidCommandsOfAxis : 0));
        return new MotionTimes(0.0, moving, (commands * SecondsPerCommand) + NoticeSeconds);
    }

    internal static MotionTimes Cut(VectorSequence sequence, MotionProgram program)
    {
        var moving = Sampled(sequence.Length, sequence.Speed, program.Profile.AccelerationCounts);
        var standing = program.Style == MotionStyle.Calls
            ? (CallCommands * SecondsPerCommand) + (CallStatements * SecondsPerStatement)
            : (SequenceCommands + SegmentsBeforeStart(sequence)) * SecondsPerCommand;
        return new MotionTimes(moving, 0.0, standing + NoticeSeconds);
    }

    private static int SegmentsBeforeStart(VectorSequence sequence)
    {
        var (sent, counts) = (0, 0.0);
        while (sent < Math.Min(sequence.Segments.Count, DmcLimits.SegmentBuffer) && counts < SecondsBufferedAtStart * sequence.Speed) counts += sequence.Segments[sent++].Length;
        return sent;
    }

    internal static double ToolSeconds(double settle) => (ToolCommands * SecondsPerCommand) + (Math.Ceiling(settle * SettleSamplesPerSecond) * Sample) + NoticeSeconds;

    /// <summary>The trapezoid up to the sample in which it ends.</summary>
    private static double Sampled(double distance, double speed, double acceleration) => Math.Ceiling(Trapezoid(distance, speed, acceleration) / Sample) * Sample;
}
