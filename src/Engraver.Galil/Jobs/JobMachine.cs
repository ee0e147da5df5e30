using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>The machine as a job uses it: commands with heartbeats between them, polls, the tool. Nothing is sent after the operator's stop.</summary>
internal sealed class JobMachine
{
    /// <summary>Readings of the path between two whole polls, on a serial line.</summary>
    internal const int GlancesBetweenPolls = 8;

    private readonly PollTimes _times;
    private readonly TimeSpan _pollInterval;
    private readonly JobLedger _ledger;
    private readonly Action _polled;
    private readonly CountsPoint? _frameGiven;
    private readonly StopOrder _order;
    private Heartbeat _heartbeat;
    private string _beat = ResidentServer.HeartbeatCommand;
    private readonly StopHandleWatch _stopHandle;
    private readonly ProgressWatch _progress;
    private readonly ToolWatch _toolWatch = new();
    private readonly JobFault _fault;
    private readonly StateQuestions _questions;
    private static readonly TimeSpan s_betweenErrors = TimeSpan.FromMilliseconds(100);

    /// <summary>On a serial line the question takes the time of a segment or two.</summary>
    private static readonly TimeSpan s_betweenErrorsOnALine = TimeSpan.FromSeconds(1);

    private long? _errorAsked;
    private bool _isGuarded;
    private int _glances;

    public JobMachine(ControllerSession session, MotionProgram program, JobOptions options, JobLedger ledger, Action polled, StopOrder stop)
    {
        Session = session;
        Profile = program.Profile;
        _questions = new StateQuestions(program.Profile.Axes, isSlow: session.Line is not null, options.FollowedAxes);
        Start = program.Start;
        _times = new PollTimes(session.Time, (session.Identity.Limits.SampleMicroseconds ?? 1000) / 1e6);
        _pollInterval = options.PollInterval;
        Tool = new JobTool(this, options.DryRun);
        _ledger = ledger;
        _polled = polled;
        Lift = options.DryRun ? DryLift.Of(program) : 0;
        _frameGiven = options.Frame is { } given ? given with { Z = given.Z + Lift } : null;
        _order = stop;
        _heartbeat = new Heartbeat(session.Time);
        _stopHandle = new StopHandleWatch(session, ledger);
        _progress = new ProgressWatch(program.Profile);
        Feed = new FeedWatch(this);
        _fault = new JobFault(this, program, ledger);
        Hold = new JobHold(this, options.Control ?? new JobControl(), options.SoftLimits);
    }

    public ControllerSession Session { get; }

    public MachineProfile Profile { get; }

    /// <summary>Assumed position of the machine at the start, job frame.</summary>
    public CountsPoint Start { get; }

    /// <summary>What the operator wants of the job, and what is in force.</summary>
    public JobHold Hold { get; }

    /// <summary>Controller seconds without progress after which a job is given up.</summary>
    public double StandstillSeconds => _progress.Seconds;

    /// <summary>The last poll; null before the first.</summary>
    public MachineState? Known { get; private set; }

    public MachineState State => Known ?? throw new InvalidOperationException("The machine was not polled yet.");

    /// <summary>What is added to a point of the job frame to get the controller's counts.</summary>
    public CountsPoint Frame => FrameTaken ?? default;

    /// <summary>As <see cref="Frame"/>; null before <see cref="TakeFrameAsync"/>.</summary>
    public CountsPoint? FrameTaken { get; private set; }

    /// <summary>How much higher than the drawing's heights everything is made: in a dry run of a tool that an axis holds, counts.</summary>
    public int Lift { get; }

    /// <summary>The frame that the job was given, before it is taken; null for none.</summary>
    public CountsPoint? FrameGiven => _frameGiven;

    /// <summary>From the job frame to the controller's own counts.</summary>
    public ControllerFrame ControllerFrame => new(default, Frame);

    /// <summary>Commanded minus actual position of each axis, counts, as it was asked with the last position; null where it was not.</summary>
    public CountsPoint? FollowingError => Known?.Error;

    /// <summary>Present position, job frame.</summary>
    public CountsPoint Here => State.Position - Frame;

    /// <summary>The job's clock.</summary>
    public TimeProvider Time => Session.Time;

    /// <summary>The serial line that the job goes over; null for none.</summary>
    public SerialLine? Line => Session.Line;

    public JobTool Tool { get; }

    /// <summary>Whether the tool output was on at the last poll, whoever switched it. A dry run has no tool.</summary>
    public bool IsToolOn => Tool.IsSeenOn(Known);

    /// <summary>Segments of the whole program that are done by a poll; null: those that are counted.</summary>
    public Func<MachineState, int>? SegmentsDone { get; set; }

    /// <summary>Writes down what is about to begin in the controller: its first segment in the whole program, the starts of its sequences, and seq before
    /// it.</summary>
    public Action<int, IReadOnlyList<int>, int> Opened { private get; set; } = (_, _, _) => { };

    /// <summary>Something is about to begin in the controller. Behind a hold that gave something up the watchdog's variables are of this job again: only
    /// now does the journal say to what they belong.</summary>
    /// <param name="first">Its first segment in the whole program.</param>
    /// <param name="starts">Segments before each of its sequences, and at last all of them.</param>
    /// <param name="calls">seq before it.</param>
    public async ValueTask<JobStep> OpenAsync(int first, IReadOnlyList<int> starts, int calls)
    {
        Opened(first, starts, calls);
        return Hold.CutBegins() ? await SendAsync(ResidentServer.MarkCommand(Mark)).ConfigureAwait(false) : JobStep.Done;
    }

    /// <summary>The number by which the watchdog's variables are known to be of this job; 0 for a move by hand.</summary>
    public int Mark { get; init; }

    /// <summary>Text to add to the report of a refused line of the program in the controller, by its line number.</summary>
    public Func<int, string> PlaceInProgram { get; set; } = _ => "";

    /// <summary>Ends every wait of the job once the operator's stop is on its way.</summary>
    public CancellationToken Stop => _order.Work;

    /// <summary>The operator has pressed STOP: what a poll shows may be an effect of it.</summary>
    public bool IsStopped => _order.IsPressed;

    /// <summary>Time since the last poll.</summary>
    public TimeSpan SincePoll => _times.SincePoll;

    /// <summary>Controller time since the job began.</summary>
    public double Seconds => _times.Seconds;

    public double WatchdogSeconds => _heartbeat.WatchdogSeconds;

    public async ValueTask<JobStep> SendAsync(string command, string where = "") => await ReplyAsync(command).ConfigureAwait(false) is Rejected rejected ? Refuse(rejected, where) : JobStep.Done;

    public async ValueTask<JobStep> SendAllAsync(IEnumerable<string> commands)
    {
        foreach (var command in commands)
        {
            if (await SendAsync(command).ConfigureAwait(false) is { Ends: true } end) return end;
        }

        return JobStep.Done;
    }

    /// <summary>Sends one command, and the heartbeat when it is due.</summary>
    public async ValueTask<Reply> ReplyAsync(string command)
    {
        if (IsBeatDueBefore(command.Length) && await Session.Commands.SendAsync(_beat, _order.ToSend()).ConfigureAwait(false) is Rejected unbeaten) return unbeaten;
        var reply = await Session.Commands.SendAsync(command, _order.ToSend()).ConfigureAwait(false);
        if (reply is Accepted && command != _beat) _progress.Acted();
        if (!_heartbeat.IsDue()) return reply;
        var beat = await Session.Commands.SendAsync(_beat, _order.ToSend()).ConfigureAwait(false);
        return beat is Rejected && reply is Accepted ? beat : reply;
    }

    /// <summary>The job stands because it is meant to.</summary>
    public void HasProgress() => _progress.Acted();

    public JobStep Refuse(Rejected rejected, string where)
    {
        _ledger.Rejected++;
        return JobStep.Refused(rejected, where);
    }

    /// <summary>Queries one number.</summary>
    public async ValueTask<(double Value, JobStep Step)> AskAsync(string operand)
    {
        var reading = await Session.Commands.ReadAsync(operand, _order.ToSend()).ConfigureAwait(false);
        return reading.Refusal is { } refused ? (0.0, Refuse(refused, "")) : (reading.Values[0], JobStep.Done);
    }

    /// <summary>Queries several numbers at once.</summary>
    public async ValueTask<(IReadOnlyList<double> Values, JobStep Step)> AskAllAsync(string operands)
    {
        var reading = await Session.Commands.ReadAsync(operands, _order.ToSend()).ConfigureAwait(false);
        return reading.Refusal is { } refused ? ([], Refuse(refused, "")) : (reading.Values, JobStep.Done);
    }

    /// <summary>A test of every polled state; null while nothing is expected of the position.</summary>
    public Func<MachineState, JobStep>? Expectation { get; set; }

    /// <summary>Knows how fast the path should be.</summary>
    public FeedWatch Feed { get; }

    /// <summary>A watch over the path of a sequence from here.</summary>
    public PathWatch Watch(CountsPoint start, IReadOnlyList<VectorSegment> segments, int speed) => new(start, segments, speed, (Session.Identity.Limits.SampleMicroseconds ?? 1000) / 1e6, Profile.Height is not null);

    /// <summary>Reads the machine's state. Ends the job when the watchdog has tripped.</summary>
    public async ValueTask<JobStep> PollAsync()
    {
        foreach (var question in _questions.Whole)
        {
            if (await ReadAsync(question).ConfigureAwait(false) is { Ends: true } end) return end;
        }

        return await PolledAsync().ConfigureAwait(false);
    }

    /// <summary>Reads only the path where a whole poll would delay the segments: on a serial line.</summary>
    public async ValueTask<JobStep> GlanceAsync()
    {
        if (Line is null || Known is null || _toolWatch.IsSuspicious || ++_glances % GlancesBetweenPolls == 0) return await PollAsync().ConfigureAwait(false);
        var withErrors = _glances % GlancesBetweenPolls == GlancesBetweenPolls / 2 ? _questions.MotionWithErrors : null;
        if (await ReadAsync(withErrors ?? _questions.Motion).ConfigureAwait(false) is { Ends: true } end) return end;
        if (withErrors is not null && !State.SequenceRunning && await ReadAsync(_questions.Motion).ConfigureAwait(false) is { Ends: true } unread) return unread; // why it ended

        // The axes were last seen in motion because of the path: now that it has ended they must be read again.
        return !State.SequenceRunning && State.AxesRunning ? await PollAsync().ConfigureAwait(false) : await PolledAsync().ConfigureAwait(false);
    }

    private async ValueTask<JobStep> ReadAsync(StateQuestion question)
    {
        if (IsBeatDueBefore(2 * question.Text.Length) && await SendAsync(_beat).ConfigureAwait(false) is { Ends: true } unbeaten) return unbeaten;
        var reading = await Session.Commands.ReadAsync(question.Text, _order.ToSend()).ConfigureAwait(false);
        if (reading.Refusal is { } refused) return Refuse(refused, "");
        Known = question.Update(Known ?? default, reading.Values);
        return JobStep.Done;
    }

    private async ValueTask<JobStep> PolledAsync()
    {
        _times.Polled(State.Time);
        if (await AskFollowingErrorAsync().ConfigureAwait(false) is { Ends: true } unasked) return unasked;
        _ledger.Trail(new TracePoint(Seconds, Here, IsToolOn) { Executed = _ledger.Executed, Error = FollowingError });
        if (IsToolOn && State.SequenceRunning && !IsStopped) _ledger.SeeCutting(SegmentsDone?.Invoke(State) ?? _ledger.Executed, Here);
        _polled();
        await _stopHandle.LookAsync().ConfigureAwait(false);
        if (await FaultAsync().ConfigureAwait(false) is { Ends: true } fault) return fault;
        if (Expectation?.Invoke(State) is { Ends: true } unexpected) return unexpected;
        if (await BeatAsync().ConfigureAwait(false) is { Ends: true } unbeaten) return unbeaten;
        return await Hold.AttendAsync().ConfigureAwait(false);
    }

    /// <summary>Asks _TE of the axes that have one (galil-dmc.md A.10) where it was not asked just now: in a message of its own, because the poll is as
    /// long as a line may be.</summary>
    private async ValueTask<JobStep> AskFollowingErrorAsync()
    {
        if (FollowingError is not null) _errorAsked = Time.GetTimestamp();
        if (_questions.Errors is not { } errors || IsStopped || FollowingError is not null || (_errorAsked is { } asked && Time.GetElapsedTime(asked) < (Line is null ? s_betweenErrors : s_betweenErrorsOnALine))) return JobStep.Done;
        _errorAsked = Time.GetTimestamp();
        return await ReadAsync(errors).ConfigureAwait(false);
    }

    /// <summary>Ends the job when a poll shows that the program in the controller has ended, the tool is not as it should be, or there is no
    /// progress.</summary>
    private async ValueTask<JobStep> FaultAsync()
    {
        if (IsStopped) return JobStep.Done; // what this poll saw may be an effect of the stop
        var isToolWrong = _toolWatch.IsWrong(State, Tool.IsOutputOn(State), Tool.Wanted(State), Tool.WantedByProgram is not null);
        var hasProgramEnded = State.Trip != 0 || State.ProgramError != 0 || !State.ProgramRuns;
        _ledger.IsToolMissing = _toolWatch.IsMissing && !hasProgramEnded; // then the controller switched it off and stopped
        if (hasProgramEnded) return await _fault.ProgramEndedAsync().ConfigureAwait(false);
        if (_isGuarded && !State.WatchdogRuns) return _fault.Unwatched();
        if (isToolWrong) return _fault.ToolSwitched();
        if (Feed.IsForeign()) return await _fault.FeedChangedAsync().ConfigureAwait(false);
        return _progress.IsStalled(State) ? await _fault.StalledAsync().ConfigureAwait(false) : JobStep.Done;
    }

    /// <summary>The program in the controller has started: waits until its watchdog runs, which is checked at every poll from then on.</summary>
    public async ValueTask<JobStep> AwaitWatchdogAsync()
    {
        if (await AwaitAsync(ResidentServer.WatchdogLine, line => line >= 0).ConfigureAwait(false) is { Ends: true } unwatched) return unwatched;
        _isGuarded = true;
        return JobStep.Done;
    }

    /// <summary>From now on the watchdog trips 0.25 s after the last sign of this computer, and signs are sent more often: for motion that lasts as long as
    /// a key is held.</summary>
    public ValueTask<JobStep> WatchCloselyAsync()
    {
        _heartbeat = Heartbeat.Close(Time);
        _beat = ResidentServer.CloseHeartbeatCommand;
        return SendAsync(_beat);
    }

    /// <summary>Brakes every axis at once, over the stop handle, beside whatever is being sent. That the link fails is found by the next poll.</summary>
    public async Task BrakeAsync()
    {
        try
        {
            await Session.StopHandle.SendAsync(BrakeCommand, CancellationToken.None).ConfigureAwait(false);
        }
        catch (ControllerException)
        {
            // The poll says so, and the dead-man brakes.
        }
    }

    public string BrakeCommand => "ST " + Profile.Axes.Letters;

    /// <summary>Looks at the machine as its watch does.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public ValueTask<MachineReading> ReadAsync() => StatusPoll.ReadAsync(Session.StopHandle, Profile.Axes, _order.ToSend());

    /// <summary>Ends the program in the controller and its watchdog; call at rest with the tool off.</summary>
    public ValueTask<JobStep> HaltProgramAsync()
    {
        _isGuarded = false;
        return SendAllAsync(ResidentServer.HaltCommands);
    }

    /// <summary>The usual watch again, behind <see cref="WatchCloselyAsync"/>.</summary>
    public ValueTask<JobStep> WatchAsUsualAsync()
    {
        _heartbeat = new Heartbeat(Time);
        _beat = ResidentServer.HeartbeatCommand;
        return SendAsync(_beat);
    }

    /// <summary>What is under way is being given up: the ledger keeps how far it was cut.</summary>
    public void Part(bool isInside)
    {
        PartedCounter = State.Counter;
        _ledger.Part(SegmentsDone?.Invoke(State) ?? _ledger.Executed, isInside ? Here : null);
    }

    /// <summary>_CSS as the sequence under way was given up.</summary>
    public int PartedCounter { get; private set; }

    private bool IsBeatDueBefore(int bytes) => Line is { } line && _heartbeat.IsDueBefore(line.Time(bytes));

    private async ValueTask<JobStep> BeatAsync() => _heartbeat.IsDue() ? await SendAsync(_beat).ConfigureAwait(false) : JobStep.Done;

    /// <summary>Queries one number over the stop handle, also after the operator's stop; null when the controller does not know it.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async ValueTask<double?> AskAtRestAsync(string operand) => (await Session.StopHandle.ReadAsync(operand, CancellationToken.None).ConfigureAwait(false)).OrNothing;

    /// <summary>Queries one number until it is as wanted, and polls in between.</summary>
    public async ValueTask<JobStep> AwaitAsync(string operand, Func<double, bool> wanted)
    {
        var (pause, start) = (new PollPause(_pollInterval, 0.0), Time.GetTimestamp());
        while (true)
        {
            var (value, end) = await AskAsync(operand).ConfigureAwait(false);
            if (end.Ends || wanted(value)) return end;
            if (await PollAsync().ConfigureAwait(false) is { Ends: true } broken) return broken;
            await RestAsync(pause.Next(Time.GetElapsedTime(start).TotalSeconds)).ConfigureAwait(false);
        }
    }

    /// <summary>Polls until <paramref name="reached"/>.</summary>
    /// <param name="atLeastSeconds">Shortest time that this can take; until then there are pauses between the polls.</param>
    public ValueTask<JobStep> PollUntilAsync(Func<MachineState, bool> reached, double atLeastSeconds = 0.0) => UntilAsync(PollAsync, reached, atLeastSeconds);

    /// <summary>The same with readings of the path (<see cref="GlanceAsync"/>).</summary>
    public ValueTask<JobStep> GlanceUntilAsync(Func<MachineState, bool> reached, double atLeastSeconds = 0.0) => UntilAsync(GlanceAsync, reached, atLeastSeconds);

    /// <summary>Pauses while the controller works, no longer than the interval between polls.</summary>
    public async ValueTask RestAsync(double seconds)
    {
        var rest = TimeSpan.FromSeconds(Math.Min(seconds, _pollInterval.TotalSeconds));
        if (rest > TimeSpan.Zero) await Task.Delay(rest, Session.Time, _order.Work).ConfigureAwait(false);
    }

    private async ValueTask<JobStep> UntilAsync(Func<ValueTask<JobStep>> look, Func<MachineState, bool> reached, double atLeastSeconds)
    {
        var (pause, start) = (new PollPause(_pollInterval, atLeastSeconds), Time.GetTimestamp());
        while (true)
        {
            if (await look().ConfigureAwait(false) is { Ends: true } end) return end;
            if (reached(State)) return JobStep.Done;
            await RestAsync(pause.Next(Time.GetElapsedTime(start).TotalSeconds)).ConfigureAwait(false);
        }
    }

    /// <summary>Defines the job frame: the one that is given, or the position at the start of the job becomes the drawing's start point.</summary>
    public async ValueTask<JobStep> TakeFrameAsync()
    {
        if (await PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        StoodAt = State.Position;
        FrameTaken = _frameGiven ?? State.Position - Start + new CountsPoint(0, 0, Lift);
        return JobStep.Done;
    }

    /// <summary>Ends the checks of the second handle.</summary>
    public ValueTask EndWatchAsync() => _stopHandle.EndAsync();

    /// <summary>Why a motion ended early, in words (<see cref="JobFault.WhyStoppedAsync"/>).</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public ValueTask<string> WhyStoppedAsync() => _fault.WhyStoppedAsync();

    /// <summary>Where the machine stood as the job frame was taken, the controller's own counts; null before.</summary>
    public CountsPoint? StoodAt { get; private set; }

    public static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
