using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Streams one VM ... VE: fills the segment buffer, begins, sends further segments by _CSS, slows down when few are left to execute, ends with VE
/// (galil-dmc.md B.7, F.1).</summary>
/// <remarks>
/// Over a network nothing repeats what the controller received. A sequence of lines is therefore sent as increments (LM, LI): a corrupted one shifts the rest
/// of the path up to its end, where the position shows it. A VP is absolute in its sequence: after a corrupted vertex the next one is right again, and where
/// segments are shorter than the distance between two polls the error would not be seen.
/// A sequence with an arc must be sent as VP and CR (LM takes no CR, galil-dmc.md B.7). There a vertex beside the path by up to about
/// sqrt((L + A/2)^2 - L^2) counts is not noticed, where L is the length of its segments and A the allowed difference of the path length: 62 counts for 100
/// segments of 60. A vertex farther off is.
/// </remarks>
/// <param name="cut">What is sent.</param>
/// <param name="first">The first of its segments that is not cut.</param>
internal sealed class SequenceFeed(JobMachine machine, JobLedger ledger, CutSequence cut, int first)
{
    /// <summary>Free places in the buffer that are not used: one command may be in transit, and the controller's count is as old as the last poll.</summary>
    private const int SpareSegments = 5;

    /// <summary>A sequence begins when this many segments are buffered, or this many seconds of motion.</summary>
    private const int StartSegments = 200;
    private const double StartSeconds = 1.0;

    /// <summary>Segments shorter than this take longer to send than to cut: the whole buffer is filled first (galil-dmc.md A.4: 1.6 ms a command).</summary>
    private const double ShortSegmentSeconds = 0.004;

    /// <summary>While the buffer is full, pauses last the time of the buffered motion divided by this.</summary>
    private const double RestShare = 4.0;

    /// <summary>Shorter delays between two commands need no extra poll, seconds.</summary>
    private const double DelaySeconds = 0.05;

    /// <summary>Largest difference between the controller's path length and the planned one, counts: it is truncated to whole counts, and how it is summed
    /// over segments is not known (galil-dmc.md B.1).</summary>
    private const double LengthAllowance = 2.0;
    private const double LengthPerSegment = 0.5;

    /// <summary>What is sent.</summary>
    private readonly VectorSequence _sequence = cut.Sequence;
    private readonly FeedPace _pace = FeedPace.From(machine.Line);
    private readonly FeedThrottle _throttle = new(Math.Max(1.0, machine.Speed.PathRatio) * cut.Sequence.Speed / cut.Sequence.AccelerationOn(machine.Profile), FeedPace.From(machine.Line).ReactionSeconds);
    private long _begunAt;
    private int _capacity;
    private int _sent;
    private int _executed;
    private int _sentAtWatch;
    private int _bytesSinceWatch;
    private int _skipped;
    /// <summary>Duration of the buffered segments at their planned speeds.</summary>
    private double _secondsAhead;
    private double[] _durations = [];
    private double _seconds;
    private bool _begun;
    private bool _byIncrements;
    private bool _statesSpeeds;
    private CountsPoint _origin;
    private PathWatch? _watch;

    /// <summary>Index of the first segment that is neither skipped nor executed.</summary>
    public int Next => first + _skipped + _executed;

    /// <summary>Duration of the buffered motion at the speed that the operator requests.</summary>
    private double SecondsAhead => _secondsAhead / machine.Speed.PathRatio;

    /// <summary>Seconds until the end of the path, by the trapezoid of the whole path and the time since its beginning.</summary>
    private double SecondsLeft => _seconds - machine.Time.GetElapsedTime(_begunAt).TotalSeconds;

    private int Remaining => _sequence.Segments.Count - first - _skipped - _sent;

    /// <summary>Fills the buffer, begins, and sends the rest while the machine cuts. Returns when the path has ended, or has run dry before its
    /// end.</summary>
    public async ValueTask RunAsync()
    {
        await OpenAsync().ConfigureAwait(false);
        if (Remaining == 0) return;
        var isReady = false;
        while (Remaining > 0 && !isReady)
        {
            await SendNextAsync().ConfigureAwait(false);
            isReady = IsReadyToBegin;
        }

        if (!isReady) await machine.Commands.SendAsync("VE").ConfigureAwait(false); // everything is in the buffer
        using var cutting = await BeginAsync().ConfigureAwait(false);
        await machine.Commands.SendAsync("BGS").ConfigureAwait(false);
        while (Remaining > 0)
        {
            if (IsTimeToWatch) await WatchAsync().ConfigureAwait(false);
            if (HasRunDry)
            {
                await CloseDryAsync().ConfigureAwait(false);
                return;
            }

            await SendNextAsync().ConfigureAwait(false);
        }

        if (isReady) await machine.Commands.SendAsync("VE").ConfigureAwait(false);
        await AwaitEndAsync().ConfigureAwait(false);
    }

    /// <summary>Confirms the segments before <paramref name="counter"/>, each once and only those that were sent.</summary>
    public void ConfirmUpTo(int counter)
    {
        for (; _executed < Math.Min(counter, _sent); _executed++)
        {
            _secondsAhead -= _durations[_executed];
            Confirm(first + _skipped + _executed);
        }
    }

    /// <summary>True every few segments; and when this computer was delayed for so long that the buffer may have run dry, which the next segment would
    /// hide.</summary>
    private bool IsTimeToWatch => machine.Hold.IsRequested || _sent - _sentAtWatch >= SegmentsBetweenPolls || machine.SincePoll.TotalSeconds > Math.Max(SecondsAhead / 2, DelaySeconds + UsualSeconds);

    /// <summary>Fewer when the buffered motion may be short by now: the machine executes it no faster than planned.</summary>
    private int SegmentsBetweenPolls => SecondsAhead - machine.SincePoll.TotalSeconds < _throttle.WatchSeconds ? _pace.SegmentsBetweenPolls : _pace.MostBetweenPolls;

    /// <summary>Places in the buffer that are surely free: those of segments that were executed since the last poll are not counted.</summary>
    private int FreePlaces => _capacity - (_sent - _executed);

    /// <summary>Time that the commands since the last poll need on a serial line, each with a heartbeat at most: that long is not a delay.</summary>
    private double UsualSeconds => machine.Line is { } line ? 2.0 * line.Time(_bytesSinceWatch).TotalSeconds : 0.0;

    private bool IsReadyToBegin =>
        _sent >= _capacity - SpareSegments
        || (!_pace.FillsFirst && Remaining > 0 && SecondsAhead / _sent >= ShortSegmentSeconds && (_sent >= StartSegments || SecondsAhead >= StartSeconds));

    /// <summary>Everything sent was executed before VE: the controller then stops at once, with the sequence open (galil-dmc.md B.7).</summary>
    private bool HasRunDry => _sentAtWatch == _sent && (machine.State.Counter >= _sent || (machine.State.Counter == _sent - 1 && machine.State.PathSpeed == 0 && _executed > 0));

    private async ValueTask OpenAsync()
    {
        await machine.PollUntilAsync(state => state.IsAtRest).ConfigureAwait(false);
        _origin = machine.Here with { Z = first == 0 ? _sequence.Start.Z : _sequence.Segments[first - 1].End.Z }; // the tool is brought to this height before the motion
        while (_skipped < _sequence.Segments.Count - first && IsAlreadyThere(_sequence.Segments[first + _skipped])) SkipOne();
        if (Remaining == 0) return;
        var ahead = Ahead;
        Measure(ahead);
        _byIncrements = !_sequence.ChangesHeight && machine.Line is null && DmcAxes.AreLeading(machine.Profile.Axes) && ahead.All(segment => segment.Kind == VectorSegmentKind.Line) && ahead.Sum(segment => segment.Length) < DmcLimits.LongestIncrements;
        await machine.Commands.SendAllAsync(["CSS", _sequence.ChangesHeight ? "LM" + machine.Profile.Axes.Letters : (_byIncrements ? "LM" : "VM") + machine.Profile.Axes.PlaneLetters]).ConfigureAwait(false);
        await machine.Settings.SendAsync(_sequence.Speed, _sequence.AccelerationOn(machine.Profile)).ConfigureAwait(false);
        _capacity = machine.Settings.Capacity;
    }

    /// <summary>Computes the planned time of each segment.</summary>
    private void Measure(IReadOnlyList<VectorSegment> ahead)
    {
        _statesSpeeds = _sequence.HasOwnSpeeds;
        var (planned, path, seconds) = (SequenceProfile.Of(_sequence with { Segments = ahead }, machine.Profile), 0.0, 0.0);
        _durations = new double[ahead.Count];
        for (var i = 0; i < ahead.Count; i++)
        {
            path += ahead[i].Length;
            var end = planned.SecondsAt(path);
            (_durations[i], seconds) = (end - seconds, end);
        }

        _seconds = planned.Seconds;
    }

    /// <summary>The segments that are cut here, from the machine's present position.</summary>
    private IReadOnlyList<VectorSegment> Ahead => [.. _sequence.Segments.Skip(first + _skipped)];

    /// <summary>A line to the machine's own position has no length and would be refused (TC 30); it counts as done.</summary>
    private bool IsAlreadyThere(in VectorSegment segment) => segment.Kind == VectorSegmentKind.Line && segment.End == _origin;

    private void SkipOne() => Confirm(first + _skipped++);

    private void Confirm(int index)
    {
        if (cut.Ended(index) is { } segment) ledger.Confirm(segment);
    }

    /// <summary>Segments of the program among the first ones that this sends.</summary>
    private int Whole(int sent) => cut.WholeAmong(first + _skipped + sent) - cut.WholeAmong(first + _skipped);

    /// <summary>Sends one segment, on a serial line as many as one line takes; while the buffer is full, sends it again (TC 32).</summary>
    /// <remarks>A line has no more segments than there are surely free places. If one of several is refused with TC 32 all the same, it is not known which of
    /// those after it are in the buffer, because places become free meanwhile: this ends the job like another refusal.</remarks>
    private async ValueTask SendNextAsync()
    {
        while (true)
        {
            while (_begun && FreePlaces < SpareSegments)
            {
                await WatchAsync().ConfigureAwait(false);
                await machine.RestAsync(SecondsAhead / RestShare).ConfigureAwait(false);
            }

            var next = await machine.Commands.ReplyAsync(Commands(Math.Clamp(FreePlaces - SpareSegments, 1, Remaining))).ConfigureAwait(false);
            var whole = Whole(_sent);
            for (var i = 0; i < next.Accepted; i++) _secondsAhead += _durations[_sent++];
            ledger.Sent += Whole(_sent) - whole;
            _bytesSinceWatch += next.Bytes;
            if (next.Reply is not Rejected rejected) return;
            if (next.Sent > 1 || !_begun || rejected.Code != TcCode.SegmentBufferFull) throw machine.Commands.Refuse(rejected, Wording.Get("Execution.DrawingEntity", Segment(_sent).EntityIndex)).ToException();
            await WatchAsync().ConfigureAwait(false);
        }
    }

    private VectorSegment Segment(int index) => _sequence.Segments[first + _skipped + index];

    /// <summary>The next segments as commands.</summary>
    private IEnumerable<string> Commands(int count) => Enumerable.Range(_sent, count).Select(Command);

    private string Command(int index)
    {
        var segment = Segment(index);
        var from = index == 0 ? _origin : Segment(index - 1).End;
        var command = _sequence.ChangesHeight ? DmcFormat.Increment(machine.Profile.Axes, from, segment.End) : _byIncrements ? DmcFormat.Increment(from, segment.End) : DmcFormat.Command(segment, _origin);
        return _statesSpeeds ? command + DmcFormat.Speed(_sequence.SpeedOf(segment)) : command;
    }

    /// <summary>Brings the tool to the work, and enters the phase in which the sequence is cut.</summary>
    private async ValueTask<PhaseScope> BeginAsync()
    {
        await machine.Hold.ToolOnAsync(_origin).ConfigureAwait(false);
        if (machine.Hold.IsRequested) await machine.Speed.SendRatioAsync().ConfigureAwait(false);
        var before = ledger.Executed - Whole(_executed);
        await machine.OpenAsync(before, [0, Whole(_sequence.Segments.Count - first - _skipped)], machine.State.Calls, [.. cut.Divided.Select(index => index - first - _skipped).Where(index => index >= 0)]).ConfigureAwait(false);
        var watch = _watch = machine.WatchPath(_origin, Ahead, _sequence.Speed);
        var planned = new PlannedSpeeds(_sequence with { Segments = Ahead }, machine.Profile);
        (_begun, _begunAt) = (true, machine.Time.GetTimestamp());
        return machine.Enter(machine.Phase with
        {
            SegmentsDone = state => before + Whole(Math.Clamp(state.Counter, _executed, Math.Max(_executed, _sent))),
            Expected = state => state.SequenceRunning ? watch.Check(state.Counter, machine.Here) : null,
            Speed = state => Remaining > 0 && state.Counter >= _sent - 1 ? null : planned.At(state.Counter), // at standstill when it runs dry
            WillMove = state => state.Counter < _sent,
            Throttle = () => _throttle.Now,
        });
    }

    /// <summary>Reads the counter.</summary>
    private async ValueTask WatchAsync()
    {
        await machine.GlanceAsync().ConfigureAwait(false);
        ConfirmUpTo(machine.State.Counter);
        (_sentAtWatch, _bytesSinceWatch) = (_sent, 0);
        if (!machine.State.SequenceRunning) throw (await EndedEarlyAsync().ConfigureAwait(false)).ToException();
        if (_throttle.Adapt(_sent - _executed, SecondsAhead, Remaining)) await machine.Hold.AttendAsync().ConfigureAwait(false);
    }

    /// <summary>Everything was sent: waits for the end of the path, and compares it with the plan.</summary>
    private async ValueTask AwaitEndAsync()
    {
        if (_throttle.Release()) await machine.Hold.AttendAsync().ConfigureAwait(false);
        await machine.GlanceUntilAsync(HasEnded, SecondsLeft).ConfigureAwait(false);
        if (machine.State.StopCode != StopCodes.SequenceEnded) throw (await EndedEarlyAsync().ConfigureAwait(false)).ToException();
        await CheckCutAsync().ConfigureAwait(false);
        ConfirmUpTo(_sent);
    }

    /// <summary>Compares the position at the end with the planned one, and the length of the path too: a closed contour ends where it began, even if
    /// no part of it was cut or a turn was too short (_AVS counts from the start of the sequence, galil-dmc.md B.1). The length is not read on a serial line,
    /// where every command was compared with its echo and a query takes long.</summary>
    private async ValueTask CheckCutAsync()
    {
        if (_watch!.LookAtEnd(_sent, machine.Here) is { } elsewhere) throw elsewhere.ToException();
        if (machine.Line is not null) return;
        var travelled = await machine.Commands.AskAsync("_AVS").ConfigureAwait(false);
        var planned = Ahead.Take(_sent).Sum(segment => segment.Length);
        if (Math.Abs(travelled - planned) > LengthAllowance + (LengthPerSegment * _sent))
            throw JobEnd.Deviated(Wording.Get("SequenceFeed.PathLengthDiffers", travelled, planned, Ahead[_sent - 1].EntityIndex, machine.Here.X, machine.Here.Y)).ToException();
    }

    private bool HasEnded(JobPoll state)
    {
        if (state.SequenceRunning) ConfirmUpTo(state.Counter);
        return state.IsAtRest;
    }

    /// <summary>Tool off at once; then, after reading what was cut, the only documented way out of an open sequence: AB1, wait, CSS.</summary>
    private async ValueTask CloseDryAsync()
    {
        ledger.Underruns++;
        var isAxis = machine.Profile.Height is not null; // of the open sequence: it cannot begin a move of its own before the sequence is ended
        if (!isAxis) await machine.Tool.OffAsync().ConfigureAwait(false);
        var deviated = await JobEnd.OfAsync(CheckCutAsync).ConfigureAwait(false);
        if (deviated is null) ConfirmUpTo(_sent);
        await machine.Commands.SendAsync("AB 1").ConfigureAwait(false);
        await machine.PollUntilAsync(state => state.IsAtRest).ConfigureAwait(false);
        using var closed = machine.Enter(machine.Phase with { Expected = null, Speed = null });
        if (isAxis) await machine.Tool.OffAsync().ConfigureAwait(false);
        if (deviated is not null) throw deviated.ToException();
        if ((await PositionQueries.AskAsync(machine.Session, machine.Profile.Axes).ConfigureAwait(false)).WithoutEncoder.Length == 0) return;
        var at = machine.State.Position;
        throw (JobEnd.Broken(Wording.Get("SequenceFeed.OutOfSegmentsWithSteppers", at.X, at.Y)) with { Doubt = Wording.Get("SequenceFeed.StepsLost") }).ToException();
    }

    private async ValueTask<JobEnd> EndedEarlyAsync()
    {
        var at = machine.State.Position;
        return JobEnd.Broken(Wording.Get("SequenceFeed.EndedEarly", at.X, at.Y, await machine.Watch.Fault.WhyStoppedAsync().ConfigureAwait(false)));
    }
}

/// <summary>How the segment buffer is filled over this kind of link.</summary>
/// <param name="SegmentsBetweenPolls">Segments between two readings of the counter when few are left to execute.</param>
/// <param name="MostBetweenPolls">The same while many are left.</param>
/// <param name="FillsFirst">The buffer is filled before the machine starts, however long the segments are: over a slow link it cannot be filled
/// later.</param>
/// <param name="ReactionSeconds">Delay between detecting that few segments are left and the command reaching the controller, seconds.</param>
internal sealed record FeedPace(int SegmentsBetweenPolls, int MostBetweenPolls, bool FillsFirst, double ReactionSeconds)
{
    /// <summary>At 1.6 ms a command (galil-dmc.md A.4): two polls and a heartbeat; <see cref="FeedLimit.ExchangesPerSegment"/>.</summary>
    private static FeedPace Network { get; } = new(28, 32, FillsFirst: false, 0.1);

    public static FeedPace From(SerialLine? line) => line is null ? Network : new FeedPace(LinkFeedLimit.SegmentsBetweenPolls, LinkFeedLimit.MostBetweenPolls(line), FillsFirst: true, LinkFeedLimit.ReactionSeconds(line));
}
