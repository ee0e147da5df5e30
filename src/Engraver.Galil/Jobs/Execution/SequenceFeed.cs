using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Streams one VM ... VE: fills the segment buffer, begins, sends further segments by _CSS, slows down when few are left to execute, ends with VE
/// (galil-dmc.md B.7, F.1).</summary>
/// <remarks>
/// Over a network nothing repeats what the controller received. A sequence of lines is therefore sent as increments (LM, LI): a damaged one shifts the rest
/// of the path up to its end, where the position shows it.
/// A VP is absolute in its sequence: after a damaged vertex the next one is right again, and where segments are shorter than the distance between two polls
/// the error would not be seen.
/// With an arc in it a sequence must go as VP and CR (LM takes no CR, galil-dmc.md B.7). There a vertex moved beside the path by up to about sqrt((L +
/// A/2)^2 - L^2) counts is not noticed, L the length of
/// its segments and A what the path length may differ by: 62 counts for 100 segments of 60. What is farther off is.
/// </remarks>
internal sealed class SequenceFeed(JobMachine machine, JobLedger ledger, VectorSequence sequence, int first)
{
    /// <summary>Free places in the buffer that are not used: one command may be on its way, and the controller's count is as old as the last poll.</summary>
    private const int SpareSegments = 5;

    /// <summary>A sequence begins when this many segments are buffered, or this many seconds of motion.</summary>
    private const int StartSegments = 200;
    private const double StartSeconds = 1.0;

    /// <summary>Segments shorter than this take longer to send than to cut: the whole buffer is filled first (galil-dmc.md A.4: 1.6 ms a command).</summary>
    private const double ShortSegmentSeconds = 0.004;

    /// <summary>While the buffer is full, pauses last the time of the buffered motion divided by this.</summary>
    private const double RestShare = 4.0;

    /// <summary>Bytes of CR and prompt.</summary>
    private const int FrameBytes = 2;

    /// <summary>Shorter delays between two commands need no extra poll, seconds.</summary>
    private const double HeldUpSeconds = 0.05;

    /// <summary>Largest difference between the controller's path length and the planned one, counts: it is truncated to whole counts, and how it is summed
    /// over segments is not known (galil-dmc.md B.1).</summary>
    private const double LengthAllowance = 2.0;
    private const double LengthPerSegment = 0.5;

    private readonly FeedPace _pace = FeedPace.From(machine.Line);
    private readonly FeedThrottle _throttle = new(Math.Max(1.0, machine.Hold.Speed.Override) * sequence.Speed / machine.Profile.AccelerationCounts, FeedPace.From(machine.Line).ReactionSeconds);
    private long _begunAt;
    private int _capacity;
    private int _sent;
    private int _executed;
    private int _sentAtWatch;
    private int _bytesSinceWatch;
    private int _skipped;
    private double _countsAhead;
    private bool _begun;
    private bool _byIncrements;
    private CountsPoint _origin;
    private PathWatch? _watch;

    /// <summary>Index of the first segment that is neither skipped nor executed.</summary>
    public int Next => first + _skipped + _executed;

    /// <summary>Duration of the buffered motion at the speed that the operator wants.</summary>
    private double SecondsAhead => _countsAhead / (sequence.Speed * machine.Hold.Speed.Override);

    /// <summary>Seconds until the end of the path, by the trapezoid of the whole path and the time since its beginning.</summary>
    private double SecondsLeft => SpeedTrapezoid.Time(Ahead.Sum(segment => segment.Length), sequence.Speed, machine.Profile.AccelerationCounts) - machine.Time.GetElapsedTime(_begunAt).TotalSeconds;

    private int Remaining => sequence.Segments.Count - first - _skipped - _sent;

    public async ValueTask<JobStep> RunAsync()
    {
        try
        {
            return await FeedAsync().ConfigureAwait(false);
        }
        finally
        {
            machine.Expectation = null;
            machine.Feed.Planned = null;
            machine.SegmentsDone = null;
            machine.Hold.WillMove = _ => true;
            machine.Hold.Speed.Throttle = 1.0;
        }
    }

    private async ValueTask<JobStep> FeedAsync()
    {
        if (await OpenAsync().ConfigureAwait(false) is { Ends: true } unopened) return unopened;
        if (Remaining == 0) return JobStep.Done;
        while (Remaining > 0)
        {
            if (IsTimeToWatch && await WatchAsync().ConfigureAwait(false) is { Ends: true } broken) return broken;
            if (_begun && HasRunDry) return await CloseDryAsync().ConfigureAwait(false);
            if (await SendNextAsync().ConfigureAwait(false) is { Ends: true } refused) return refused;
            if (!_begun && IsReadyToBegin && await BeginAsync().ConfigureAwait(false) is { Ends: true } unbegun) return unbegun;
        }

        return await CloseAsync().ConfigureAwait(false);
    }

    /// <summary>Confirms the segments before <paramref name="counter"/>, each once and only those that were sent.</summary>
    public void ConfirmUpTo(int counter)
    {
        for (; _executed < Math.Min(counter, _sent); _executed++)
        {
            var segment = sequence.Segments[first + _skipped + _executed];
            _countsAhead -= segment.Length;
            ledger.Confirm(segment);
        }
    }

    /// <summary>True every few segments; and when this computer was delayed for so long that the buffer may have run dry, which the next segment would
    /// hide.</summary>
    private bool IsTimeToWatch => _begun && (machine.Hold.IsAsked || _sent - _sentAtWatch >= _pace.SegmentsBetweenPolls || machine.SincePoll.TotalSeconds > Math.Max(SecondsAhead / 2, HeldUpSeconds + UsualSeconds));

    /// <summary>Time that the commands since the last poll need on a serial line, with a heartbeat for each at worst: that long is not a delay.</summary>
    private double UsualSeconds => machine.Line is { } line ? 2.0 * line.Time(_bytesSinceWatch).TotalSeconds : 0.0;

    private bool IsReadyToBegin =>
        _sent >= _capacity - SpareSegments
        || (!_pace.FillsFirst && Remaining > 0 && SecondsAhead / _sent >= ShortSegmentSeconds && (_sent >= StartSegments || SecondsAhead >= StartSeconds));

    /// <summary>Everything sent was executed before VE: the controller then stops at once, with the sequence open (galil-dmc.md B.7).</summary>
    private bool HasRunDry => _sentAtWatch == _sent && (machine.State.Counter >= _sent || (machine.State.Counter == _sent - 1 && machine.State.PathSpeed == 0 && _executed > 0));

    private async ValueTask<JobStep> OpenAsync()
    {
        if (await machine.PollUntilAsync(state => state.Stands).ConfigureAwait(false) is { Ends: true } end) return end;
        _origin = machine.Here with { Z = first == 0 ? sequence.Start.Z : sequence.Segments[first - 1].End.Z }; // the tool is brought to this height before the motion
        while (_skipped < sequence.Segments.Count - first && IsAlreadyThere(sequence.Segments[first + _skipped])) SkipOne();
        if (Remaining == 0) return JobStep.Done;
        var ahead = Ahead;
        _byIncrements = !sequence.ChangesHeight && machine.Line is null && DmcAxes.AreFirst(machine.Profile.Axes) && ahead.All(segment => segment.Kind == VectorSegmentKind.Line) && ahead.Sum(segment => segment.Length) < DmcLimits.LongestIncrements;
        var acceleration = machine.Profile.AccelerationCounts;
        var opened = await machine.SendAllAsync(["CSS", sequence.ChangesHeight ? "LM" + machine.Profile.Axes.Letters : (_byIncrements ? "LM" : "VM") + machine.Profile.Axes.PlaneLetters, Text($"VSS={sequence.Speed}"), Text($"VAS={acceleration}"), Text($"VDS={acceleration}")]).ConfigureAwait(false);
        if (opened.Ends) return opened;
        if (await SettingCheck.ReadBackAsync(
            machine, ("_VSS", sequence.Speed, SettingCheck.Speed), ("_VAS", acceleration, SettingCheck.Acceleration), ("_VDS", acceleration, SettingCheck.Acceleration)).ConfigureAwait(false) is { Ends: true } harmed) return harmed;
        if (await machine.Hold.SendRatioAsync().ConfigureAwait(false) is { Ends: true } another) return another;
        return await AskCapacityAsync().ConfigureAwait(false);
    }

    /// <summary>The segments that are cut here, from the machine's present position.</summary>
    private IReadOnlyList<VectorSegment> Ahead => [.. sequence.Segments.Skip(first + _skipped)];

    private JobStep OnPath(MachineState state) => state.SequenceRunning ? _watch!.Look(state.Counter, machine.Here) : JobStep.Done;

    /// <summary>A line to the machine's own position has no length and would be refused (TC 30); it counts as done.</summary>
    private bool IsAlreadyThere(in VectorSegment segment) => segment.Kind == VectorSegmentKind.Line && segment.End == _origin;

    private void SkipOne() => ledger.Confirm(sequence.Segments[first + _skipped++]);

    private async ValueTask<JobStep> AskCapacityAsync()
    {
        var (capacity, end) = await machine.AskAsync("_LMS").ConfigureAwait(false);
        _capacity = (int)capacity;
        return end;
    }

    /// <summary>Sends one segment; while the buffer is full, sends it again (TC 32).</summary>
    private async ValueTask<JobStep> SendNextAsync()
    {
        var segment = sequence.Segments[first + _skipped + _sent];
        var from = _sent == 0 ? _origin : sequence.Segments[first + _skipped + _sent - 1].End;
        var command = sequence.ChangesHeight ? DmcFormat.Increment(machine.Profile.Axes, from, segment.End) : _byIncrements ? DmcFormat.Increment(from, segment.End) : DmcFormat.Command(segment, _origin);
        while (true)
        {
            while (_begun && _capacity - (_sent - _executed) < SpareSegments)
            {
                if (await WatchAsync().ConfigureAwait(false) is { Ends: true } end) return end;
                await machine.RestAsync(SecondsAhead / RestShare).ConfigureAwait(false);
            }

            var reply = await machine.ReplyAsync(command).ConfigureAwait(false);
            if (reply is Accepted) break;
            if (reply is Rejected rejected && !(rejected.Code == TcCode.SegmentBufferFull && _begun)) return machine.Refuse(rejected, Wording.Get("Execution.DrawingEntity", segment.EntityIndex));
            if (await WatchAsync().ConfigureAwait(false) is { Ends: true } broken) return broken;
        }

        _sent++;
        _bytesSinceWatch += command.Length + FrameBytes;
        ledger.Sent++;
        _countsAhead += segment.Length;
        return JobStep.Done;
    }

    private async ValueTask<JobStep> BeginAsync()
    {
        if (await machine.Hold.ToolOnAsync(_origin).ConfigureAwait(false) is { Ends: true } end) return end;
        if (machine.Hold.IsAsked && await machine.Hold.SendRatioAsync().ConfigureAwait(false) is { Ends: true } unset) return unset;
        var before = ledger.Executed - _executed;
        machine.SegmentsDone = state => before + Math.Clamp(state.Counter, _executed, Math.Max(_executed, _sent));
        if (await machine.OpenAsync(before, [0, sequence.Segments.Count - first - _skipped], machine.State.Calls).ConfigureAwait(false) is { Ends: true } unopened) return unopened;
        machine.Hold.WillMove = state => state.Counter < _sent;
        _watch = machine.Watch(_origin, Ahead, sequence.Speed);
        machine.Expectation = OnPath;
        machine.Feed.Planned = state => Remaining > 0 && state.Counter >= _sent - 1 ? null : PlannedSpeed.Of(sequence.Speed); // running dry it stands
        _begun = true;
        _begunAt = machine.Time.GetTimestamp();
        return await machine.SendAsync("BGS").ConfigureAwait(false);
    }

    /// <summary>Reads the counter.</summary>
    private async ValueTask<JobStep> WatchAsync()
    {
        if (await machine.GlanceAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        ConfirmUpTo(machine.State.Counter);
        (_sentAtWatch, _bytesSinceWatch) = (_sent, 0);
        if (!machine.State.SequenceRunning) return await EndedEarlyAsync().ConfigureAwait(false);
        return _throttle.Ratio(_sent - _executed, SecondsAhead, Remaining) is { } ratio ? await ThrottleAsync(ratio).ConfigureAwait(false) : JobStep.Done;
    }

    private async ValueTask<JobStep> CloseAsync()
    {
        if (await machine.SendAsync("VE").ConfigureAwait(false) is { Ends: true } refused) return refused;
        if (!_begun && await BeginAsync().ConfigureAwait(false) is { Ends: true } unbegun) return unbegun;
        if (_throttle.Release() is { } ratio && await ThrottleAsync(ratio).ConfigureAwait(false) is { Ends: true } unreleased) return unreleased;
        if (await machine.GlanceUntilAsync(HasEnded, SecondsLeft).ConfigureAwait(false) is { Ends: true } end) return end;
        if (machine.State.StopCode != StopCodes.SequenceEnded) return await EndedEarlyAsync().ConfigureAwait(false);
        if (await CheckCutAsync().ConfigureAwait(false) is { Ends: true } another) return another;
        ConfirmUpTo(_sent);
        return JobStep.Done;
    }

    private async ValueTask<JobStep> ThrottleAsync(double ratio)
    {
        machine.Hold.Speed.Throttle = ratio;
        return await machine.Hold.AttendAsync().ConfigureAwait(false);
    }

    /// <summary>Compares the position at the end with the planned one, and the length of the path too: a closed contour ends where it began, even if
    /// nothing of it was cut or a turn was too short
    /// (_AVS counts from the start of the sequence, galil-dmc.md B.1). The length is not read on a serial line, where every command was compared with its
    /// echo and a query takes long.</summary>
    private async ValueTask<JobStep> CheckCutAsync()
    {
        if (_watch!.LookAtEnd(_sent, machine.Here) is { Ends: true } elsewhere) return elsewhere;
        if (machine.Line is not null) return JobStep.Done;
        var (travelled, end) = await machine.AskAsync("_AVS").ConfigureAwait(false);
        if (end.Ends) return end;
        var planned = Ahead.Take(_sent).Sum(segment => segment.Length);
        return Math.Abs(travelled - planned) <= LengthAllowance + (LengthPerSegment * _sent)
            ? JobStep.Done
            : JobStep.Deviated(Wording.Get("SequenceFeed.PathLengthDiffers", travelled, planned, Ahead[_sent - 1].EntityIndex, machine.Here.X, machine.Here.Y));
    }

    private bool HasEnded(MachineState state)
    {
        if (state.SequenceRunning) ConfirmUpTo(state.Counter);
        return state.Stands;
    }

    /// <summary>Tool off at once; then, after reading what was cut, the only documented way out of an open sequence: AB1, wait, CSS.</summary>
    private async ValueTask<JobStep> CloseDryAsync()
    {
        ledger.Underruns++;
        var isHeld = machine.Profile.Height is not null; // by an axis of the open sequence, which cannot begin a move of its own before that is ended
        if (!isHeld && await machine.Tool.OffAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        var cut = await CheckCutAsync().ConfigureAwait(false);
        if (!cut.Ends) ConfirmUpTo(_sent);
        if (await machine.SendAsync("AB 1").ConfigureAwait(false) is { Ends: true } refused) return refused;
        if (await machine.PollUntilAsync(state => state.Stands).ConfigureAwait(false) is { Ends: true } broken) return broken;
        (machine.Expectation, machine.Feed.Planned) = (null, null);
        if (isHeld && await machine.Tool.OffAsync().ConfigureAwait(false) is { Ends: true } down) return down;
        if (cut.Ends || (await PlaceQuestions.AskAsync(machine.Session, machine.Profile.Axes).ConfigureAwait(false)).Uncounted.Length == 0) return cut;
        var at = machine.State.Position;
        return JobStep.Broken(Wording.Get("SequenceFeed.OutOfSegmentsWithSteppers", at.X, at.Y)) with { Doubt = Wording.Get("SequenceFeed.StepsLost") };
    }

    private async ValueTask<JobStep> EndedEarlyAsync()
    {
        var at = machine.State.Position;
        return JobStep.Broken(Wording.Get("SequenceFeed.EndedEarly", at.X, at.Y, await machine.WhyStoppedAsync().ConfigureAwait(false)));
    }
}

/// <summary>How the segment buffer is filled over this kind of link.</summary>
/// <param name="SegmentsBetweenPolls">Segments between two readings of the counter.</param>
/// <param name="FillsFirst">The buffer is filled before the machine starts, however long the segments are: over a slow link it cannot be filled later.</param>
/// <param name="ReactionSeconds">Delay between detecting that few segments are left and the command reaching the controller, seconds.</param>
internal sealed record FeedPace(int SegmentsBetweenPolls, bool FillsFirst, double ReactionSeconds)
{
    /// <summary>At 1.6 ms a command (galil-dmc.md A.4): two polls and a heartbeat.</summary>
    private static FeedPace Network { get; } = new(16, FillsFirst: false, 0.06);

    public static FeedPace From(SerialLine? line) => line is null ? Network : new FeedPace(LinkFeedLimit.SegmentsBetweenPolls, FillsFirst: true, LinkFeedLimit.ReactionSeconds(line));
}
