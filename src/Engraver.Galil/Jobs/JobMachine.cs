using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>The machine as the strategies of a job use it: its polls, its waits, and the phase by which every poll is judged. Commands, tool, hold and
/// watch are parts with a class each.</summary>
/// <remarks>Every method that waits ends the job by an exception (<see cref="JobEnd"/>) when a poll shows that it cannot continue.</remarks>
internal sealed class JobMachine
{
    private readonly TimeSpan _pollInterval;
    private readonly JobLedger _ledger;
    private readonly JobLog _log;
    private readonly StopOrder _order;
    private readonly StateReader _reader;

    public JobMachine(ControllerSession session, MotionProgram program, JobOptions options, JobLedger ledger, JobLog log, StopOrder order)
    {
        (Session, Profile, _pollInterval, _ledger, _log, _order) = (session, program.Profile, options.PollInterval, ledger, log, order);
        var progress = new ProgressWatch(program);
        Commands = new JobCommands(session, order, ledger, progress);
        _reader = new StateReader(session, program.Profile.Axes, options.FollowedAxes, Commands, order);
        Frame = new JobCoordinates(program, options);
        Tool = new JobTool(this, options.DryRun);
        var control = options.Control ?? new JobControl();
        Speed = new JobSpeed(this, program, control);
        Settings = new MotionSettings(this);
        Hold = new JobHold(this, control, log, options.SoftLimits);
        Watch = new JobWatch(this, program, ledger, progress);
    }

    public ControllerSession Session { get; }

    public MachineProfile Profile { get; }

    /// <summary>The serial line that the job uses; null for a network.</summary>
    public SerialLine? Line => Session.Line;

    /// <summary>Total time in which a command or transfer of this session was under way on the command handle.</summary>
    public TimeSpan LinkBusy => Session.Commands.Busy;

    /// <summary>The job's clock.</summary>
    public TimeProvider Time => Session.Time;

    /// <summary>The number by which the watchdog's variables are known to be of this job; 0 for a move by hand.</summary>
    public int Mark { get; init; }

    public JobCommands Commands { get; }

    public JobCoordinates Frame { get; }

    public JobTool Tool { get; }

    /// <summary>The overrides in force.</summary>
    public JobSpeed Speed { get; }

    /// <summary>Settings of the motion that the host commands.</summary>
    public MotionSettings Settings { get; }

    /// <summary>What the job does about a hold that the operator requests.</summary>
    public JobHold Hold { get; }

    /// <summary>What every poll must show.</summary>
    public JobWatch Watch { get; }

    /// <summary>What the job is doing.</summary>
    public Phase Phase { get; private set; } = Phase.Idle;

    /// <summary>The last poll; null before the first.</summary>
    public JobPoll? Known => _reader.Known;

    /// <summary>The last poll.</summary>
    public JobPoll State => _reader.State;

    /// <summary>Present position, job frame.</summary>
    public CountsPoint Here => State.Position - Frame.Origin;

    /// <summary>Whether the tool was at work at the last poll, whichever host or program switched it on. A dry run has no tool.</summary>
    public bool IsToolOn => Tool.IsSeenOn(Known);

    /// <summary>Time since the last poll.</summary>
    public TimeSpan SincePoll => _reader.SincePoll;

    /// <summary>Controller time since the job began.</summary>
    public double Seconds => _reader.Seconds;

    /// <summary>Ends every wait of the job once the operator's stop has been sent.</summary>
    public CancellationToken Stop => _order.Work;

    /// <summary>The operator has pressed STOP: what a poll shows may be an effect of it.</summary>
    public bool IsStopped => _order.IsPressed;

    /// <summary>Brakes every axis of the job.</summary>
    public string BrakeCommand => "ST " + Profile.Axes.Letters;

    /// <summary>_CSS when the sequence in progress was given up.</summary>
    public int CounterGivenUp { get; private set; }

    /// <summary>From here on the job is in this phase, until the scope is disposed.</summary>
    public PhaseScope Enter(Phase phase)
    {
        var scope = new PhaseScope(this, Phase);
        Phase = phase;
        return scope;
    }

    /// <summary>Called by the scope of a phase.</summary>
    public void Leave(Phase before) => Phase = before;

    /// <summary>Compares the path of a sequence with the planned one, from here on.</summary>
    public PathWatch WatchPath(CountsPoint start, IReadOnlyList<VectorSegment> segments, int speed) => new(start, segments, speed, (Session.Identity.Limits.SampleMicroseconds ?? 1000) / 1e6, Profile.Height is not null);

    /// <summary>Reads the machine's state, judges it, sends the heartbeat if it is due, and does what the operator requests of the job.</summary>
    public async ValueTask PollAsync()
    {
        await _reader.ReadAsync().ConfigureAwait(false);
        await EndPollAsync().ConfigureAwait(false);
    }

    /// <summary>The same; reads only the path where a whole poll would delay the segments: on a serial line.</summary>
    public async ValueTask GlanceAsync()
    {
        await _reader.GlanceAsync(isWhole: Watch.IsToolSuspicious).ConfigureAwait(false);
        await EndPollAsync().ConfigureAwait(false);
    }

    private async ValueTask EndPollAsync()
    {
        _ledger.Trail(new TracePoint(Seconds, Here, IsToolOn) { Executed = _ledger.Executed, Error = State.Error });
        if (IsToolOn && State.SequenceRunning && !IsStopped) _ledger.SeeCutting(SegmentsDone, Here);
        _log.Polled(this);
        await Watch.CheckAsync().ConfigureAwait(false);
        await Commands.BeatAsync().ConfigureAwait(false);
        await Hold.AttendAsync().ConfigureAwait(false);
    }

    /// <summary>Polls until <paramref name="reached"/>.</summary>
    /// <param name="atLeastSeconds">Shortest time that this can take; until then there are pauses between the polls.</param>
    public ValueTask PollUntilAsync(Func<JobPoll, bool> reached, double atLeastSeconds = 0.0) => UntilAsync(PollAsync, reached, atLeastSeconds);

    /// <summary>The same with readings of the path (<see cref="GlanceAsync"/>).</summary>
    public ValueTask GlanceUntilAsync(Func<JobPoll, bool> reached, double atLeastSeconds = 0.0) => UntilAsync(GlanceAsync, reached, atLeastSeconds);

    private async ValueTask UntilAsync(Func<ValueTask> poll, Func<JobPoll, bool> reached, double atLeastSeconds)
    {
        var (pause, start) = (new PollPause(_pollInterval, atLeastSeconds), Time.GetTimestamp());
        while (true)
        {
            await poll().ConfigureAwait(false);
            if (reached(State)) return;
            await RestAsync(pause.Next(Time.GetElapsedTime(start).TotalSeconds)).ConfigureAwait(false);
        }
    }

    /// <summary>Queries one number until it is the one that is awaited, and polls in between.</summary>
    public async ValueTask AwaitAsync(string operand, Func<double, bool> isAwaited)
    {
        var (pause, start) = (new PollPause(_pollInterval, 0.0), Time.GetTimestamp());
        while (!isAwaited(await Commands.AskAsync(operand).ConfigureAwait(false)))
        {
            await PollAsync().ConfigureAwait(false);
            await RestAsync(pause.Next(Time.GetElapsedTime(start).TotalSeconds)).ConfigureAwait(false);
        }
    }

    /// <summary>Pauses while the controller works, no longer than the interval between polls.</summary>
    public async ValueTask RestAsync(double seconds)
    {
        var rest = TimeSpan.FromSeconds(Math.Min(seconds, _pollInterval.TotalSeconds));
        if (rest > TimeSpan.Zero) await Task.Delay(rest, Time, _order.Work).ConfigureAwait(false);
    }

    /// <summary>Reads what the machine strip shows, over the stop handle.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public ValueTask<MachineReading> ReadStatusAsync() => StatusPoll.ReadAsync(Session.StopHandle, Profile.Axes, _order.ToSend());

    /// <summary>The program in the controller was started: waits until its watchdog runs, which every poll checks from then on.</summary>
    public async ValueTask AwaitWatchdogAsync()
    {
        Commands.KeepBeating();
        await AwaitAsync(ResidentServer.WatchdogLine, line => line >= 0).ConfigureAwait(false);
        Watch.IsGuarded = true;
    }

    /// <summary>Ends the program in the controller and its watchdog; call at rest with the tool off.</summary>
    public async ValueTask HaltProgramAsync()
    {
        await Commands.EndBeatingAsync().ConfigureAwait(false);
        Watch.IsGuarded = false;
        await Commands.SendAllAsync(ResidentServer.HaltCommands).ConfigureAwait(false);
    }

    /// <summary>Defines the job frame (<see cref="JobCoordinates.Take"/>).</summary>
    public async ValueTask TakeFrameAsync()
    {
        await PollAsync().ConfigureAwait(false);
        Frame.Take(State.Position);
    }

    /// <summary>Call before a sequence, call or program begins in the controller: the journal states what the controller counts from here on. After a hold
    /// that gave up what was in progress, the watchdog's variables belong to this job again.</summary>
    /// <param name="first">Its first segment in the whole program.</param>
    /// <param name="starts">Segments before each of its sequences, and as the last number all of them.</param>
    /// <param name="calls">seq before it.</param>
    /// <param name="divided">As <see cref="JournalOpened.Divided"/>.</param>
    public async ValueTask OpenAsync(int first, IReadOnlyList<int> starts, int calls, IReadOnlyList<int>? divided = null)
    {
        _log.Opened(new JournalOpened(first, starts, calls) { Divided = divided is { Count: > 0 } ? divided : null });
        if (Hold.CutBegins()) await Commands.SendAsync(ResidentServer.MarkCommand(Mark)).ConfigureAwait(false);
    }

    /// <summary>What is in progress is given up: the ledger keeps how far it was cut.</summary>
    /// <param name="isInside">In the middle of a sequence.</param>
    public void GiveUp(bool isInside)
    {
        CounterGivenUp = State.Counter;
        _ledger.GiveUp(SegmentsDone, isInside ? Here : null);
        Tool.GiveUp();
        Settings.Forget();
        _log.SequenceDone(this);
    }

    /// <summary>Segments of the whole program that are done.</summary>
    private int SegmentsDone => Phase.SegmentsDone?.Invoke(State) ?? _ledger.Executed;
}
