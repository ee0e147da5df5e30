using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Timing;

/// <summary>A job run over the network: every command takes the same time, independent of its length.</summary>
internal sealed class EthernetTimes : DmcTimes
{
    /// <summary>One command and its reply over Ethernet (galil-dmc.md A.4).</summary>
    private const double SecondsPerCommand = 0.0016;

    /// <summary>An end of motion is detected by the next poll, half a command later on average.</summary>
    private const double NoticeSeconds = SecondsPerCommand / 2.0;

    /// <summary>Commands of a rapid: a poll before it, SP and PA of each axis that moves, the query of SP, BG.</summary>
    private const int RapidCommands = 3;
    private const int RapidCommandsOfAxis = 2;

    /// <summary>Commands of a tool change: SB or CB, and the poll from which the settle time counts.</summary>
    private const int ToolCommands = 2;

    /// <summary>Commands of a move of the tool axis: SP, PA, the speed read back, BG, and half of a poll in two lines.</summary>
    private const int HeightCommands = 5;

    /// <summary>Commands of a sequence: a poll, CSS, VM, VS, VA, VD and their query, VR and its query, the query for free places, VE, BGS, and the query of the
    /// length at its end.</summary>
    private const int SequenceCommands = 13;

    /// <summary>Motion that is buffered before a stream starts to move, seconds; the rest is sent meanwhile.</summary>
    private const double SecondsBufferedAtStart = 1.0;

    /// <summary>Commands of a call: a poll, the arguments and go.</summary>
    private const int CallCommands = 3;

    public override double Loading(MotionProgram program) => 0.0;

    public override double Rapid(CountsPoint from, CountsPoint to, double moving, MotionProgram program)
    {
        if (from == to) return SecondsPerCommand;
        var commands = RapidCommands + (from.X != to.X ? RapidCommandsOfAxis : 0) + (from.Y != to.Y ? RapidCommandsOfAxis : 0);
        return (commands * SecondsPerCommand) + NoticeSeconds;
    }

    public override double Sequence(VectorSequence sequence, double moving, MotionProgram program) => NoticeSeconds + (program.Style == MotionStyle.Calls
        ? (CallCommands * SecondsPerCommand) + SecondsPerCall
        : (SequenceCommands + SegmentsBeforeStart(sequence)) * SecondsPerCommand);

    public override double Tool(CountsPoint at, bool on, double moving, MotionProgram program) => program.Profile.Height is null
        ? (ToolCommands * SecondsPerCommand) + Settle(program, on) + NoticeSeconds
        : MovesOfTool(on) * ((HeightCommands * SecondsPerCommand) + NoticeSeconds);

    public override double Wait(CountsPoint at, double seconds) => Waited(seconds) + SecondsPerCommand + NoticeSeconds;

    private static int SegmentsBeforeStart(VectorSequence sequence)
    {
        var (sent, counts) = (0, 0.0);
        while (sent < Math.Min(sequence.Segments.Count, DmcLimits.SegmentBuffer) && counts < SecondsBufferedAtStart * sequence.Speed) counts += sequence.Segments[sent++].Length;
        return sent;
    }
}
