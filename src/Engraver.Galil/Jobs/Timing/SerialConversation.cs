using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs.Timing;

/// <summary>Simulates the exchange of a job over a serial line byte by byte, with the heartbeats between (<see cref="JobCommands"/>,
/// <see cref="Heartbeat"/>), to find the time of each exchange.</summary>
/// <remarks>Averages are not accurate enough: a poll takes as long as a settle or a short cut, so that one more or less matters, and that depends on the
/// digits of a reply. All times are seconds since the job began.</remarks>
internal sealed class SerialConversation(SerialLine line)
{
    /// <summary>Bytes of CR and prompt for each part of a line.</summary>
    private const int FrameBytes = 2;

    /// <summary>Interval of a job's heartbeats, alone and in lines of segments, and the latest time after which one is sent before a long exchange.</summary>
    private const double SecondsBetweenHeartbeats = 0.2;
    private const double SecondsBetweenHeartbeatsWithSegments = 0.3;
    private const double LatestHeartbeat = 0.5;

    /// <summary>Assumed bytes of handshake and downloads before the job, for TIME at its beginning on a controller that has just been switched on.</summary>
    private const int BytesBeforeJob = 3000;

    private const int ThreadLineDigits = 2;

    /// <summary>Letters do not matter: only the length of a query does.</summary>
    private static readonly StateQuestions s_questions = new(MachineAxes.Default, isSlow: true, followed: "");

    private readonly double _byteSeconds = line.ByteSeconds;
    private double _beaten;
    private int _glances;
    private double _movingUntil;
    private int _speed;
    private bool _axesSeenMoving;

    public double Now { get; private set; }

    /// <summary>Calls counted by the program in the controller.</summary>
    public int Calls { get; set; }

    /// <summary>_CSS as it will be printed.</summary>
    public int Counter { get; set; }

    /// <summary>_SCA while the axes are at rest.</summary>
    public int StopCode { get; set; }

    /// <summary>When the controller received the CR of the last line; its prompt followed.</summary>
    public double Heard => Now - _byteSeconds;

    /// <summary>A pause of the host between two polls, seconds.</summary>
    public void Rest(double seconds) => Now += seconds;

    /// <summary>A motion has started.</summary>
    /// <param name="speed">_VMS meanwhile; 0 for a rapid.</param>
    public void Moves(double until, int speed) => (_movingUntil, _speed) = (until, speed);

    public void Command(string text)
    {
        BeatBefore(text.Length);
        Pass(text.Length + 1 + text.AsSpan().Count(';') + 1);
        BeatAfter();
    }

    /// <summary>Segments, as many in a line as it takes, and the heartbeat in front of some lines.</summary>
    public void Segments(IReadOnlyList<string> segments)
    {
        for (var sent = 0; sent < segments.Count;)
        {
            var beats = StreamLines.Fit(line, ResidentServer.HeartbeatCommand, segments[sent]) && Now - _beaten >= SecondsBetweenHeartbeatsWithSegments;
            if (beats) _beaten = Now;
            var statements = StreamLines.Next(line, beats ? ResidentServer.HeartbeatCommand : null, segments.Skip(sent));
            sent += statements.Count - (beats ? 1 : 0);
            if (statements.Count == 1)
            {
                Command(statements[0]);
                continue;
            }

            var bytes = statements.Sum(statement => statement.Length + FrameBytes);
            BeatBefore(bytes);
            Pass(bytes);
        }
    }

    /// <summary>A single query, without a heartbeat.</summary>
    public void Ask(string operand, int digits) => Pass(Question(operand) + Answer(digits));

    /// <summary>A whole poll.</summary>
    /// <returns>When the controller replied to each of its two parts.</returns>
    public (double Program, double Path) Poll(CountsPoint at)
    {
        var asked = AskProgram();
        var path = AskMotion(at);
        BeatAfter();
        return (asked, path);
    }

    /// <summary>A reading of the path, now and then a whole poll.</summary>
    /// <returns>When the controller replied, and whether the axes were at rest in this reading.</returns>
    public (double At, bool Stands) Glance(CountsPoint at)
    {
        var isWhole = ++_glances % StateReader.GlancesBetweenPolls == 0;
        if (isWhole) AskProgram();
        var path = AskMotion(at);
        if (!isWhole && path >= _movingUntil && _axesSeenMoving)
        {
            AskProgram(); // last seen in motion because of the path: now that it has ended they must be read again
            path = AskMotion(at);
        }

        BeatAfter();
        return (path, path >= _movingUntil && !_axesSeenMoving);
    }

    /// <summary>_SCA during motion: a sequence has its own code, a rapid has 0.</summary>
    private int RunningCode => _speed > 0 ? StopCodes.SequenceRunning : 0;

    private double AskProgram()
    {
        BeatBefore(2 * s_questions.Program.Text.Length);
        Pass(Question(s_questions.Program.Text));
        var asked = Now;
        _axesSeenMoving = asked < _movingUntil;
        Pass(Answer(1, 1, Digits(Calls), ThreadLineDigits, ThreadLineDigits, 1));
        return asked;
    }

    private double AskMotion(CountsPoint at)
    {
        BeatBefore(2 * s_questions.Motion.Text.Length);
        Pass(Question(s_questions.Motion.Text));
        var (asked, moves) = (Now, Now < _movingUntil);
        Pass(Answer(1, Digits(Counter), moves ? Digits(_speed) : 1, Digits(at.X), Digits(at.Y), Digits((asked + (BytesBeforeJob * _byteSeconds)) / DmcTimes.SampleSeconds), Digits(moves ? RunningCode : StopCode), 1, 1));
        return asked;
    }

    private void BeatBefore(int bytes)
    {
        if (Now > _beaten && Now - _beaten + (bytes * _byteSeconds) >= LatestHeartbeat) Beat();
    }

    private void BeatAfter()
    {
        if (Now - _beaten >= SecondsBetweenHeartbeats) Beat();
    }

    private void Beat()
    {
        _beaten = Now;
        Pass(ResidentServer.HeartbeatCommand.Length + FrameBytes);
    }

    private void Pass(int bytes) => Now += bytes * _byteSeconds;

    private static int Question(string operands) => "MG ".Length + operands.Length + 1;

    /// <summary>Bytes of a reply: numbers, each after a blank or a sign; line end and prompt.</summary>
    private static int Answer(params ReadOnlySpan<int> digits)
    {
        var bytes = digits.Length + 3;
        foreach (var count in digits) bytes += count;
        return bytes;
    }

    private static int Digits(double value) => Math.Abs(value) < 1.0 ? 1 : (int)Math.Log10(Math.Abs(value)) + 1;
}
