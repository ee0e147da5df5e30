using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Timing;

/// <summary>A job run over the network: every command takes the same time, independent of its length. For one estimate in the order of cutting.</summary>
internal sealed class EthernetTimes : DmcTimes
{
    /// <summary>One command and its reply over Ethernet (galil-dmc.md A.4).</summary>
    private const double SecondsPerCommand = 0.0016;

    /// <summary>An end of motion is detected by the next poll, half a command later on average.</summary>
    private const double NoticeSeconds = SecondsPerCommand / 2.0;

    /// <summary>Commands of a rapid: a poll before it, BG, and PA of each axis that moves; SP before the first one of the axis.</summary>
    private const int RapidCommands = 2;
    private const int RapidCommandsOfAxis = 1;
    private const int RapidSpeedCommands = 1;

    /// <summary>Commands of a tool change: SB or CB, and the poll from which the settle time counts.</summary>
    private const int ToolCommands = 2;

    /// <summary>Commands of a move of the tool axis: PA, BG, and half of a poll in two lines; SP and its query, where the move before had another
    /// speed.</summary>
    private const int HeightCommands = 3;
    private const int HeightSpeedCommands = 2;

    /// <summary>Commands of a sequence: a poll, CSS, VM, VE, BGS, and the query of the length at its end.</summary>
    private const int SequenceCommands = 6;

    /// <summary>VS where it changes, VA and VD where they change, and their query.</summary>
    private const int SpeedCommands = 1;
    private const int AccelerationCommands = 2;
    private const int QueryCommands = 1;

    /// <summary>Before the first sequence: VR and its query, and the query for free places.</summary>
    private const int FirstCommands = 3;

    private bool _hasSpeedOfX;
    private bool _hasSpeedOfY;
    private int _speed;
    private int _acceleration;

    /// <summary>Motion that is buffered before a stream starts to move, seconds; the rest is sent meanwhile.</summary>
    private const double SecondsBufferedAtStart = 1.0;

    /// <summary>Commands of a call: a poll, the arguments and go.</summary>
    private const int CallCommands = 3;

    public override double Loading(MotionProgram program) => 0.0;

    public override double Rapid(CountsPoint from, CountsPoint to, double moving, MotionProgram program)
    {
        if (from == to) return SecondsPerCommand;
        var (isFirstOfX, isFirstOfY) = (from.X != to.X && !_hasSpeedOfX, from.Y != to.Y && !_hasSpeedOfY);
        var commands = RapidCommands + (from.X != to.X ? RapidCommandsOfAxis : 0) + (from.Y != to.Y ? RapidCommandsOfAxis : 0);
        commands += (isFirstOfX ? RapidSpeedCommands : 0) + (isFirstOfY ? RapidSpeedCommands : 0) + (isFirstOfX || isFirstOfY ? QueryCommands : 0);
        (_hasSpeedOfX, _hasSpeedOfY) = (_hasSpeedOfX || isFirstOfX, _hasSpeedOfY || isFirstOfY);
        return (commands * SecondsPerCommand) + NoticeSeconds;
    }

    public override double Sequence(VectorSequence sequence, double moving, MotionProgram program) => NoticeSeconds + (program.Style == MotionStyle.Calls
        ? (CallCommands * SecondsPerCommand) + SecondsPerCall
        : (SequenceCommands + SettingCommands(sequence.Speed, sequence.AccelerationOn(program.Profile)) + SegmentsBeforeStart(sequence)) * SecondsPerCommand);

    public override double Tool(CountsPoint at, bool on, double moving, MotionProgram program) => program.Profile.Height is null
        ? (ToolCommands * SecondsPerCommand) + Settle(program, on) + NoticeSeconds
        : (MovesOfTool(on) * ((HeightCommands * SecondsPerCommand) + NoticeSeconds)) + (HeightSpeedCommands * SecondsPerCommand); // to the plunge feed, or back to rapid

    public override double Wait(CountsPoint at, double seconds) => Waited(seconds) + SecondsPerCommand + NoticeSeconds;

    private int SettingCommands(int speed, int acceleration)
    {
        var commands = (speed != _speed ? SpeedCommands : 0) + (acceleration != _acceleration ? AccelerationCommands : 0);
        var first = _acceleration == 0 ? FirstCommands : 0;
        (_speed, _acceleration) = (speed, acceleration);
        return commands + (commands > 0 ? QueryCommands : 0) + first;
    }

    private static int SegmentsBeforeStart(VectorSequence sequence)
    {
        var (sent, counts) = (0, 0.0);
        while (sent < Math.Min(sequence.Segments.Count, DmcLimits.SegmentBuffer) && counts < SecondsBufferedAtStart * sequence.Speed) counts += sequence.Segments[sent++].Length;
        return sent;
    }
}
