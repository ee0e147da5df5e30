using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs.Timing;

/// <summary>The talk of a job over a serial line as it would go, byte by byte and with the heartbeats between (<see cref="JobMachine"/>, <see cref="Heartbeat"/>): how late it is behind each word.</summary>
/// <remarks>Averages will not do: a poll takes as long as a settle or a short cut, so that one more or less is what decides, and the digits of an answer decide that. All times are seconds since the job began.</remarks>
internal sealed class SerialConversation(SerialLine line)
{
    /// <summary>CR, and the prompt of each part.</summary>
    private const int FrameBytes = 2;

    /// <summary>As a job spaces its heartbeats, and the latest for which one is not said before a long exchange.</summary>
    private const double SecondsBetweenHeartbeats = 0.2;
    private const double LatestHeartbeat = 0.5;

    /// <summary>TIME when a job begins on a controller that has just been switched on: handshake and downloads are about so many bytes.</summary>
    private const int BytesBeforeJob = 3000;

    private const int ThreadLineDigits = 2;

    /// <summary>Letters do not matter: only the length of a question does.</summary>
    private static readonly StateQuestions s_questions = new(MachineAxes.Default);

    private readonly double _byteSeconds = line.ByteSeconds;
    private double _beaten;
    private int _glances;
    private double _movingUntil;
    private int _speed;
    private bool _axesSeenMoving;

    public double Now { get; private set; }

    /// <summary>Calls that the program in the controller has counted.</summary>
    public int Calls { get; set; }

    /// <summary>_CSS as it is printed.</summary>
    public int Counter { get; set; }

    /// <summary>_SCA while the axes stand.</summary>
    public int StopCode { get; set; }

    /// <summary>When the controller had the CR of what was said last: the prompt came behind it.</summary>
    public double Heard => Now - _byteSeconds;

    /// <summary>The host rests between two polls, seconds.</summary>
    public void Rest(double seconds) => Now += seconds;

    /// <summary>A motion is under way.</summary>
    /// <param name="speed">_VMS meanwhile; 0 for a rapid.</param>
    public void Moves(double until, int speed) => (_movingUntil, _speed) = (until, speed);

    public void Command(string text)
    {
        BeatBefore(text.Length);
        Pass(text.Length + 1 + text.AsSpan().Count(';') + 1);
        BeatAfter();
    }

    /// <summary>A single question, which no heartbeat goes with.</summary>
    public void Ask(string operand, int digits) => Pass(Question(operand) + Answer(digits));

    /// <summary>A whole poll.</summary>
    /// <returns>When each of the two questions was answered by the controller.</returns>
    public (double Program, double Path) Poll(CountsPoint at)
    {
        var asked = AskProgram();
        var path = AskMotion(at);
        BeatAfter();
        return (asked, path);
    }

    /// <summary>A look at the path alone, now and then a whole poll.</summary>
    /// <returns>When it was answered by the controller, and whether the axes stood as far as was seen.</returns>
    public (double At, bool Stands) Glance(CountsPoint at)
    {
        var isWhole = ++_glances % JobMachine.GlancesBetweenPolls == 0;
        if (isWhole) AskProgram();
        var path = AskMotion(at);
        if (!isWhole && path >= _movingUntil && _axesSeenMoving)
        {
            AskProgram(); // last seen at work for the path: now that it has ended they must be asked again
            path = AskMotion(at);
        }

        BeatAfter();
        return (path, path >= _movingUntil && !_axesSeenMoving);
    }

    /// <summary>_SCA while something moves: the sequence has a code of its own, a rapid none.</summary>
    private int RunningCode => _speed > 0 ? StopCodes.SequenceRunning : 0;

    private double AskProgram()
    {
        BeatBefore(2 * s_questions.Program.Length);
        Pass(Question(s_questions.Program));
        var asked = Now;
        _axesSeenMoving = asked < _movingUntil;
        Pass(Answer(1, 1, Digits(Calls), ThreadLineDigits, ThreadLineDigits, 1));
        return asked;
    }

    private double AskMotion(CountsPoint at)
    {
        BeatBefore(2 * s_questions.Motion.Length);
        Pass(Question(s_questions.Motion));
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

    /// <summary>Numbers, each behind a blank or a sign; line end and prompt.</summary>
    private static int Answer(params ReadOnlySpan<int> digits)
    {
        var bytes = digits.Length + 3;
        foreach (var count in digits) bytes += count;
        return bytes;
    }

    private static int Digits(double value) => Math.Abs(value) < 1.0 ? 1 : (int)Math.Log10(Math.Abs(value)) + 1;
}
