using Engraver.Galil.Links;
using Engraver.Galil.Programs;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs;

/// <summary>A job led over a serial line: every byte of a question, a command and an answer takes its time (galil-dmc.md A.2), and an end is noticed by the next question only.</summary>
internal sealed class SerialTimes(SerialLine line) : CommandTimes
{
    /// <summary>CR, and the prompt of each part.</summary>
    private const int FrameBytes = 2;

    /// <summary>As a job spaces them (<see cref="Heartbeat"/>); each is noticed when what is being said has been said.</summary>
    private const double SecondsBetweenHeartbeats = 0.2;

    /// <summary>Digits of a place, a time and a counter in an answer, with the blank in front; what is asked beside them has one digit.</summary>
    private const int TimeDigits = 6;
    private const int SpeedDigits = 5;
    private const int CounterDigits = 2;
    private const int CodeDigits = 3;

    private readonly double _byteSeconds = Loaded(line);

    private double ProgramQuestion => Bytes(Question(MachineState.ProgramOperands));

    private double ProgramAnswer => Bytes(Answer(1, 1, CodeDigits, CounterDigits, 1));

    private double MotionQuestion => Bytes(Question(MachineState.MotionOperands));

    internal override double Loading(MotionProgram program) => 0.0;

    internal override double Rapid(CountsPoint from, CountsPoint to, double moving, MotionProgram program)
    {
        var standing = Poll(from);
        if (from == to) return standing;
        var commands = new List<string>();
        if (from.X != to.X) commands.AddRange([Text($"SPA={program.Profile.RapidSpeedX}"), Text($"PAA={to.X}")]);
        if (from.Y != to.Y) commands.AddRange([Text($"SPB={program.Profile.RapidSpeedY}"), Text($"PAB={to.Y}")]);
        commands.Add(from.X != to.X && from.Y != to.Y ? "BGAB" : "BGA");
        return standing + commands.Sum(Command) + Unnoticed(moving, ProgramQuestion, Poll(to)) + ProgramAnswer + Motion(to);
    }

    internal override double Sequence(VectorSequence sequence, double moving, MotionProgram program) => program.Style == MotionStyle.Calls
        ? Call(sequence, moving)
        : Opening(sequence, program) + SegmentsBeforeStart(sequence) + Command("BGS") + SequenceEnd(sequence.End, moving);

    internal override double Tool(CountsPoint at, MotionProgram program)
    {
        var glance = Glance(at);
        return Command("SB 1") + Motion(at) + (glance * Math.Max(1.0, Math.Ceiling(Settle(program) / glance)));
    }

    /// <summary>The server works a little before and behind the motion; the end is seen by a whole poll, for it is <c>seq</c> that tells it.</summary>
    private double Call(VectorSequence sequence, double moving)
    {
        var arguments = ResidentServer.Arguments(sequence.Segments[0], sequence.Start, sequence.Speed);
        var working = moving + SecondsPerCall;
        return Poll(sequence.Start) + Command(arguments) + Command(ResidentServer.GoCommand)
            + SecondsPerCall + Unnoticed(working, ProgramQuestion, Poll(sequence.End)) + ProgramAnswer + Motion(sequence.End);
    }

    private double Opening(VectorSequence sequence, MotionProgram program)
    {
        var acceleration = program.Profile.AccelerationCounts;
        string[] commands = ["CSS", "VMAB", Text($"VSS={sequence.Speed}"), Text($"VAS={acceleration}"), Text($"VDS={acceleration}"), "VR 1"];
        return Poll(sequence.Start) + commands.Sum(Command) + Bytes(Question("_LMS") + Answer(CodeDigits));
    }

    /// <summary>The buffer is filled before the machine starts; what does not fit, and then VE, is sent while it moves.</summary>
    private double SegmentsBeforeStart(VectorSequence sequence)
    {
        var fits = sequence.Segments.Count <= WireFeed.Places;
        return sequence.Segments.Take(WireFeed.Places).Sum(segment => Command(DmcFormat.Command(segment, sequence.Start))) + (fits ? Command("VE") : 0.0);
    }

    /// <summary>The path is glanced at; when a whole poll has seen the axes at work for it they must be asked again.</summary>
    private double SequenceEnd(CountsPoint end, double moving)
    {
        var glance = Glance(end);
        var askedAgain = Math.Min(1.0, moving / glance / GlancesBetweenPolls) * Poll(end);
        return Unnoticed(moving, MotionQuestion, glance) + Motion(end) - MotionQuestion + askedAgain;
    }

    /// <summary>From the end of a motion until the first question behind it has been asked.</summary>
    /// <param name="first">When the first question has been asked, seconds after the motion began.</param>
    /// <param name="period">Between two questions.</param>
    private static double Unnoticed(double moving, double first, double period) => first + (period * Math.Max(0.0, Math.Ceiling((moving - first) / period))) - moving;

    private double Poll(CountsPoint at) => ProgramQuestion + ProgramAnswer + Motion(at);

    private double Motion(CountsPoint at) => MotionQuestion + Bytes(Answer(1, CounterDigits, SpeedDigits, Digits(at.X), Digits(at.Y), TimeDigits, CodeDigits, 1, 1));

    /// <summary>On average: now and then it is a whole poll.</summary>
    private double Glance(CountsPoint at) => Motion(at) + ((ProgramQuestion + ProgramAnswer) / GlancesBetweenPolls);

    private double Command(string text) => Bytes(text.Length + 1 + text.AsSpan().Count(';') + 1);

    private double Bytes(int count) => count * _byteSeconds;

    private static int Question(string operands) => "MG ".Length + operands.Length + 1;

    /// <summary>Numbers, each behind a blank or a sign; line end and prompt.</summary>
    private static int Answer(params ReadOnlySpan<int> digits)
    {
        var bytes = digits.Length + 3;
        foreach (var count in digits) bytes += count;
        return bytes;
    }

    private static int Digits(int value) => value == 0 ? 1 : (int)Math.Log10(Math.Abs((double)value)) + 1;

    /// <summary>The line with its share of heartbeats.</summary>
    private static double Loaded(SerialLine line)
    {
        var heartbeat = (ResidentServer.HeartbeatCommand(WatchdogLimit.OneSecond).Length + FrameBytes) * line.ByteSeconds;
        var late = (Question(MachineState.MotionOperands) + FrameBytes) * line.ByteSeconds / 2.0;
        return line.ByteSeconds * (1.0 + (heartbeat / (SecondsBetweenHeartbeats + late)));
    }
}
