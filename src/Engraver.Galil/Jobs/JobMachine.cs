using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Watching;
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

    private readonly ControllerSession _session;
    private readonly PollTimes _times;
    private readonly TimeSpan _pollInterval;
    private readonly JobLedger _ledger;
    private readonly Action _polled;
    private readonly CountsPoint? _frameGiven;
    private readonly CancellationToken _stop;
    private readonly Heartbeat _heartbeat;
    private readonly StopHandleWatch _stopHandle;
    private readonly ProgressWatch _progress;
    private readonly ToolWatch _toolWatch = new();
    private readonly JobFault _fault;
    private readonly StateQuestions _questions;
    private bool _isGuarded;
    private int _glances;

    public JobMachine(ControllerSession session, MotionProgram program, JobOptions options, JobLedger ledger, Action polled, CancellationToken stop)
    {
        _session = session;
        Profile = program.Profile;
        _questions = new StateQuestions(program.Profile.Axes);
        Start = program.Start;
        _times = new PollTimes(session.Time, (session.Identity.Limits.SampleMicroseconds ?? 1000) / 1e6);
        _pollInterval = options.PollInterval;
        Tool = new JobTool(this, options.DryRun);
        _ledger = ledger;
        _polled = polled;
        _frameGiven = options.Frame;
        _stop = stop;
        _heartbeat = new Heartbeat(session.Time);
        _stopHandle = new StopHandleWatch(session, ledger);
        _progress = new ProgressWatch(program.Profile);
        _fault = new JobFault(this, program, ledger);
    }

    public MachineProfile Profile { get; }

    /// <summary>Assumed position of the machine at the start, job frame.</summary>
    public CountsPoint Start { get; }

    /// <summary>Controller seconds without progress after which a job is given up.</summary>
    public double StandstillSeconds => _progress.Seconds;

    /// <summary>The last poll; null before the first.</summary>
    public MachineState? Known { get; private set; }

    public MachineState State => Known ?? throw new InvalidOperationException("The machine was not polled yet.");

    /// <summary>What is added to a point of the job frame to get the controller's counts.</summary>
    public CountsPoint Frame => FrameTaken ?? default;

    /// <summary>As <see cref="Frame"/>; null before <see cref="TakeFrameAsync"/>.</summary>
    public CountsPoint? FrameTaken { get; private set; }

    /// <summary>From the job frame to the controller's own counts.</summary>
    public ControllerFrame ControllerFrame => new(default, Frame);

    /// <summary>Present position, job frame.</summary>
    public CountsPoint Here => new(State.Position.X - Frame.X, State.Position.Y - Frame.Y);

    /// <summary>The job's clock.</summary>
    public TimeProvider Time => _session.Time;

    /// <summary>The serial line that the job goes over; null for none.</summary>
    public SerialLine? Line => _session.Line;

    public JobTool Tool { get; }

    /// <summary>Whether the tool output was on at the last poll, whoever switched it. A dry run has no tool.</summary>
    public bool IsToolOn => Tool.IsSeenOn(Known);

    /// <summary>Text to add to the report of a refused line of the program in the controller, by its line number.</summary>
    public Func<int, string> PlaceInProgram { get; set; } = _ => "";

    /// <summary>The operator's stop.</summary>
    public CancellationToken Stop => _stop;

    /// <summary>Time since the last poll.</summary>
    public TimeSpan SincePoll => _times.SincePoll;

    /// <summary>Controller time since the job began.</summary>
    public double Seconds => _times.Seconds;

    public async ValueTask<JobStep> SendAsync(string command, string where = "") =>
        await ReplyAsync(command).ConfigureAwait(false) is Rejected rejected ? Refuse(rejected, where) : JobStep.Done;

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
        if (IsBeatDueBefore(command.Length) && await _session.Commands.SendAsync(ResidentServer.HeartbeatCommand, _stop).ConfigureAwait(false) is Rejected unbeaten) return unbeaten;
        var reply = await _session.Commands.SendAsync(command, _stop).ConfigureAwait(false);
        if (reply is Accepted && command != ResidentServer.HeartbeatCommand) _progress.Acted();
        if (!_heartbeat.IsDue()) return reply;
        var beat = await _session.Commands.SendAsync(ResidentServer.HeartbeatCommand, _stop).ConfigureAwait(false);
        return beat is Rejected && reply is Accepted ? beat : reply;
    }

    public JobStep Refuse(Rejected rejected, string where)
    {
        _ledger.Rejected++;
        return JobStep.Refused(rejected, where);
    }

    /// <summary>Queries one number.</summary>
    public async ValueTask<(double Value, JobStep Step)> AskAsync(string operand)
    {
        var reading = await _session.Commands.ReadAsync(operand, _stop).ConfigureAwait(false);
        return reading.Refusal is { } refused ? (0.0, Refuse(refused, "")) : (reading.Values[0], JobStep.Done);
    }

    /// <summary>Queries several numbers at once.</summary>
    public async ValueTask<(IReadOnlyList<double> Values, JobStep Step)> AskAllAsync(string operands)
    {
        var reading = await _session.Commands.ReadAsync(operands, _stop).ConfigureAwait(false);
        return reading.Refusal is { } refused ? ([], Refuse(refused, "")) : (reading.Values, JobStep.Done);
    }

    /// <summary>A test of every polled state; null while nothing is expected of the position.</summary>
    public Func<MachineState, JobStep>? Expectation { get; set; }

    /// <summary>A watch over the path of a sequence from here.</summary>
    public PathWatch Watch(CountsPoint start, IReadOnlyList<VectorSegment> segments, int speed) => new(start, segments, speed, (_session.Identity.Limits.SampleMicroseconds ?? 1000) / 1e6);

    /// <summary>Reads the machine's state. Ends the job when the watchdog has tripped.</summary>
    public async ValueTask<JobStep> PollAsync()
    {
        if (Line is null) return await ReadAsync(_questions.All, MachineState.From).ConfigureAwait(false) is { Ends: true } silent ? silent : await PolledAsync().ConfigureAwait(false);
        if (await ReadAsync(_questions.Program, (Known ?? default).WithProgram).ConfigureAwait(false) is { Ends: true } end) return end;
        return await ReadAsync(_questions.Motion, State.WithMotion).ConfigureAwait(false) is { Ends: true } broken ? broken : await PolledAsync().ConfigureAwait(false);
    }

    /// <summary>Reads only the path where a whole poll would delay the segments: on a serial line.</summary>
    public async ValueTask<JobStep> GlanceAsync()
    {
        if (Line is null || Known is null || _toolWatch.IsSuspicious || ++_glances % GlancesBetweenPolls == 0) return await PollAsync().ConfigureAwait(false);
        if (await ReadAsync(_questions.Motion, State.WithMotion).ConfigureAwait(false) is { Ends: true } end) return end;

        // The axes were last seen in motion because of the path: now that it has ended they must be read again.
        return !State.SequenceRunning && State.AxesRunning ? await PollAsync().ConfigureAwait(false) : await PolledAsync().ConfigureAwait(false);
    }

    private async ValueTask<JobStep> ReadAsync(string operands, Func<IReadOnlyList<double>, MachineState> take)
    {
        if (IsBeatDueBefore(2 * operands.Length) && await SendAsync(ResidentServer.HeartbeatCommand).ConfigureAwait(false) is { Ends: true } unbeaten) return unbeaten;
        var reading = await _session.Commands.ReadAsync(operands, _stop).ConfigureAwait(false);
        if (reading.Refusal is { } refused) return Refuse(refused, "");
        Known = take(reading.Values);
        return JobStep.Done;
    }

    private async ValueTask<JobStep> PolledAsync()
    {
        _times.Polled(State.Time);
        _ledger.Trail(new TracePoint(Seconds, Here.X, Here.Y, IsToolOn) { Executed = _ledger.Executed });
        _polled();
        await _stopHandle.LookAsync().ConfigureAwait(false);
        if (await FaultAsync().ConfigureAwait(false) is { Ends: true } fault) return fault;
        if (Expectation?.Invoke(State) is { Ends: true } unexpected) return unexpected;
        return await BeatAsync().ConfigureAwait(false);
    }

    /// <summary>Ends the job when a poll shows that the program in the controller has ended, the tool is not as it should be, or there is no progress.</summary>
    private async ValueTask<JobStep> FaultAsync()
    {
        if (_stop.IsCancellationRequested) return JobStep.Done; // what this poll saw may be an effect of the stop
        var isToolWrong = _toolWatch.IsWrong(State, Tool.IsOutputOn(State), Tool.Wanted(State), Tool.WantedByProgram is not null);
        var hasProgramEnded = State.Trip != 0 || State.ProgramError != 0 || !State.ProgramRuns;
        _ledger.IsToolMissing = _toolWatch.IsMissing && !hasProgramEnded; // then the controller switched it off and stopped
        if (hasProgramEnded) return await ProgramEndedAsync().ConfigureAwait(false);
        if (_isGuarded && !State.WatchdogRuns) return _fault.Unwatched();
        if (isToolWrong) return _fault.ToolSwitched();
        return _progress.IsStalled(State) ? await _fault.StalledAsync().ConfigureAwait(false) : JobStep.Done;
    }

    /// <summary>The program in the controller has started: waits until its watchdog runs, which is checked at every poll from then on.</summary>
    public async ValueTask<JobStep> AwaitWatchdogAsync()
    {
        if (await AwaitAsync(ResidentServer.WatchdogLine, line => line >= 0).ConfigureAwait(false) is { Ends: true } unwatched) return unwatched;
        _isGuarded = true;
        return JobStep.Done;
    }

    /// <summary>Ends the program in the controller and its watchdog; call at rest with the tool off.</summary>
    public ValueTask<JobStep> HaltProgramAsync()
    {
        _isGuarded = false;
        return SendAllAsync(ResidentServer.HaltCommands);
    }

    private bool IsBeatDueBefore(int bytes) => Line is { } line && _heartbeat.IsDueBefore(line.Time(bytes));

    private async ValueTask<JobStep> BeatAsync() =>
        _heartbeat.IsDue() ? await SendAsync(ResidentServer.HeartbeatCommand).ConfigureAwait(false) : JobStep.Done;

    /// <summary>Queries one number over the stop handle, also after the operator's stop; null when the controller does not know it.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async ValueTask<double?> AskAtRestAsync(string operand) => (await _session.StopHandle.ReadAsync(operand, CancellationToken.None).ConfigureAwait(false)).OrNothing;

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
        if (rest > TimeSpan.Zero) await Task.Delay(rest, _session.Time, _stop).ConfigureAwait(false);
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
        FrameTaken = _frameGiven ?? new CountsPoint(State.Position.X - Start.X, State.Position.Y - Start.Y);
        return JobStep.Done;
    }

    /// <summary>Ends the checks of the second handle.</summary>
    public ValueTask EndWatchAsync() => _stopHandle.EndAsync();

    public static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    /// <summary>Reports why the program in the controller has ended: the watchdog tripped, one of its lines was refused, or somebody halted it.</summary>
    private async ValueTask<JobStep> ProgramEndedAsync()
    {
        if (State.Trip == WatchdogProgram.ToolForgotten) return _fault.ToolForgotten();
        if (State.Trip != 0)
            return JobStep.LinkLost(Wording.Get("JobMachine.ControllerHeardNothingFrom"), LinkLoss.Watchdog);
        if (State.ProgramError == 0) return await ProgramHaltedAsync().ConfigureAwait(false);
        if (State.ProgramError == SupervisedProgram.Strayed)
            return JobStep.Broken(Wording.Get("JobMachine.MotionEndedBeforeIts", State.Position.X, State.Position.Y, StopCodes.Text(State.StopCode)));
        if (State.ProgramError == PositionErrorProgram.Code) return await CannotFollowAsync().ConfigureAwait(false);
        var (line, _) = await AskAsync(ResidentProgram.Variables.ErrorLine).ConfigureAwait(false);
        var code = (TcCode)State.ProgramError;
        return Refuse(new Rejected(code, TcCodes.Text(code), Wording.Get("JobMachine.LineDownloadedProgram", line)), PlaceInProgram((int)line));
    }

    /// <summary>Reports a position error larger than ER: the axis is jammed, or driven faster than its motor can follow.</summary>
    private async ValueTask<JobStep> CannotFollowAsync()
    {
        var (x, y) = (Profile.Axes.X.Letter, Profile.Axes.Y.Letter);
        var (errorX, errorY) = (await AskAtRestAsync($"_TE{x}").ConfigureAwait(false), await AskAtRestAsync($"_TE{y}").ConfigureAwait(false));
        var far = errorX is { } first && errorY is { } second ? Wording.Get("JobMachine.CountsOff", x, first, y, second) : "";
        return JobStep.Broken(Wording.Get("JobMachine.PositionErrorBecameLarger", State.Position.X, State.Position.Y, far)) with { Doubt = Wording.Get("JobMachine.CouldNotFollow") };
    }

    /// <summary>Reports a halt from outside: by the abort input (galil-dmc.md D), which leaves its stop code at an axis that moved and <c>_AB</c> 0 while it is active, by AB, or by HX.</summary>
    private async ValueTask<JobStep> ProgramHaltedAsync()
    {
        var where = Wording.Get("Common.At", State.Position.X, State.Position.Y);
        if (State.StopCode == StopCodes.AbortInput || await AskAtRestAsync("_AB").ConfigureAwait(false) == 0)
            return JobStep.Broken(Wording.Get("JobMachine.AbortInputControllerHit", where));
        return JobStep.Broken(Wording.Get("JobMachine.SomebodyHaltedProgramController", StopCodes.Text(State.StopCode), where));
    }
}
