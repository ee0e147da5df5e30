using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs.Timing;

/// <summary>A job that this computer commands over a serial line: every byte of a query, a command and a reply takes its time (galil-dmc.md A.2), and an
/// end is detected only by the next query.</summary>
/// <remarks>For one estimate: the time of a step depends on the steps before it, so they are added in the order of cutting.</remarks>
internal sealed class SerialTimes(SerialLine line) : DmcTimes
{
    private const int CapacityDigits = 3;

    private readonly SerialConversation _talk = new(line);
    private readonly HashSet<char> _rapids = [];
    private int _speed;
    private int _acceleration;

    public override double Loading(MotionProgram program) => 0.0;

    public override double Rapid(CountsPoint from, CountsPoint to, double moving, MotionProgram program)
    {
        var begun = _talk.Now;
        _talk.Poll(from);
        if (from == to) return _talk.Now - begun;
        var axes = RapidMove.Moving(program.Profile.Axes, from, to);
        foreach (var (axis, _) in axes)
        {
            if (_rapids.Add(axis.Letter)) SayAll(MotionSettings.SpeedOf(axis.Letter, program.Profile.RapidSpeed(axis)));
        }

        foreach (var (axis, goal) in axes) SayAll(RapidMove.GoalOf(axis, goal));
        _talk.Command("BG" + string.Concat(axes.Select(moving => moving.Axis.Letter)));
        var end = _talk.Heard + moving;
        _talk.Moves(end, 0);
        PollUntil(to, end, moving);
        _talk.StopCode = StopCodes.AtTarget;
        return _talk.Now - begun - moving;
    }

    public override double Sequence(VectorSequence sequence, double moving, MotionProgram program)
    {
        var begun = _talk.Now;
        _talk.Poll(sequence.Start);
        if (program.Style == MotionStyle.Calls) Call(sequence, moving, sequence.AccelerationOn(program.Profile));
        else Stream(sequence, moving, program.Profile);
        _talk.StopCode = StopCodes.SequenceEnded;
        return _talk.Now - begun - moving;
    }

    public override double Tool(CountsPoint at, bool on, double moving, MotionProgram program)
    {
        var begun = _talk.Now;
        if (program.Profile.Axes.Z is { } z && program.Profile.Height is not null)
        {
            for (var move = 0; move < MovesOfTool(on); move++)
            {
                if (_rapids.Add(z.Letter) || move > 0 || !on) SayAll(MotionSettings.SpeedOf(z.Letter, program.Profile.RapidSpeed(z))); // rapid, plunge, rapid
                SayAll(RapidMove.GoalOf(z, at.Z), "BG" + z.Letter);
                var end = _talk.Heard + (moving / MovesOfTool(on));
                _talk.Moves(end, 0);
                PollUntil(at, end, moving / MovesOfTool(on));
            }

            return _talk.Now - begun - moving;
        }

        var seconds = on ? program.Profile.ToolSettleSeconds : program.Profile.OffSettleSeconds;
        _talk.Command("SB 1");
        WaitFor(at, seconds);
        return _talk.Now - begun;
    }

    public override double Wait(CountsPoint at, double seconds)
    {
        var begun = _talk.Now;
        WaitFor(at, seconds);
        return _talk.Now - begun;
    }

    private void WaitFor(CountsPoint at, double seconds)
    {
        var from = _talk.Glance(at).At;
        var (pause, start) = (Pause(seconds), _talk.Now);
        while (_talk.Glance(at).At - from < Waited(seconds)) _talk.Rest(pause.Next(_talk.Now - start));
    }

    /// <summary>The server works for a short time before and after the motion; its end is seen by a whole poll, which contains <c>seq</c>.</summary>
    private void Call(VectorSequence sequence, double moving, int acceleration)
    {
        SayAll(ResidentServer.Arguments(sequence.Segments[0], sequence.Start, sequence.Speed, acceleration), ResidentServer.GoCommand);
        var end = _talk.Heard + SecondsPerCall + moving;
        _talk.Moves(end, sequence.Speed);
        PollUntil(sequence.End, end, moving);
        _talk.Calls++;
    }

    /// <summary>The buffer is filled before the machine starts; what does not fit, and then VE, is sent while it moves.</summary>
    private void Stream(VectorSequence sequence, double moving, MachineProfile profile)
    {
        var acceleration = sequence.AccelerationOn(profile);
        SayAll("CSS", sequence.ChangesHeight ? "LM" + profile.Axes.Letters : "VM" + profile.Axes.PlaneLetters);
        if (sequence.Speed != _speed) SayAll(DmcFormat.Text($"VSS={sequence.Speed}"));
        if (acceleration != _acceleration) SayAll(DmcFormat.Text($"VAS={acceleration}"), DmcFormat.Text($"VDS={acceleration}"));
        if (_acceleration == 0)
        {
            SayAll("VR 1");
            _talk.Ask("_LMS", CapacityDigits);
        }

        (_speed, _acceleration) = (sequence.Speed, acceleration);
        _talk.Counter = 0;
        var fits = sequence.Segments.Count <= LinkFeedLimit.Places;
        var segments = DmcFormat.Commands(sequence, profile.Axes).ToList();
        _talk.Segments([.. segments.Take(LinkFeedLimit.Places)]);
        if (fits) _talk.Command("VE");
        var begun = _talk.Now;
        _talk.Command("BGS");
        _talk.Moves(_talk.Heard + moving, sequence.Speed);
        _talk.Segments([.. segments.Skip(LinkFeedLimit.Places)]);
        if (!fits) _talk.Command("VE");
        _talk.Counter = sequence.Segments.Count;
        var (pause, start) = (Pause(moving - (_talk.Now - begun)), _talk.Now);
        while (!_talk.Glance(sequence.End).Stands) _talk.Rest(pause.Next(_talk.Now - start));
    }

    private void SayAll(params ReadOnlySpan<string> commands)
    {
        foreach (var command in commands) _talk.Command(command);
    }

    /// <param name="atLeast">Time for which the job will pause, seconds from now, because the end cannot come sooner.</param>
    private void PollUntil(CountsPoint at, double end, double atLeast)
    {
        var (pause, start) = (Pause(atLeast), _talk.Now);
        while (_talk.Poll(at).Program < end) _talk.Rest(pause.Next(_talk.Now - start));
    }

    private static PollPause Pause(double atLeast) => new(JobOptions.UsualPollInterval, atLeast);
}
