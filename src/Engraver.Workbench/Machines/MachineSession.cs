using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Machines.Terminals;

namespace Engraver.Workbench.Machines;

/// <summary>The machine the operator works with: one controller, and what it is doing. The other of the two places that change over time.</summary>
/// <remarks>While connected the controller is looked at ten times a second over handles of the session's own; while a job runs the job tells. Status, stop and abort may be used from any thread.</remarks>
public sealed class MachineSession : IAsyncDisposable
{
    private readonly TimeProvider _time;
    private readonly MachineStatusModel _status;
    private readonly ActiveJob _work;
    private readonly WatchedConnection _watched;
    private ControllerPlace? _place;

    public MachineSession(TimeProvider time)
    {
        _time = time;
        _status = new MachineStatusModel(time, RaiseChanged);
        _watched = new WatchedConnection(time, () => Profile.Axes, Seen, _status.Lost);
        _work = new ActiveJob(_status.JobIsOver, RaiseChanged);
        Terminal = new LiveTerminal(time, AnswerAsync);
    }

    /// <summary>Raised when a connection or a job begins or ends, with each look at the controller and each progress; on any thread.</summary>
    public event EventHandler? Changed;

    /// <summary>What is known now.</summary>
    public MachineStatus Status => _status.Status;

    public AlarmLog Alarms => _status.Alarms;

    /// <summary>The terminal's page.</summary>
    public LiveTerminal Terminal { get; }

    /// <summary>The machine by which counts become millimetres and the tool's output is known. Another one disarms.</summary>
    public MachineProfile Profile
    {
        get => _status.Profile;
        set => _status.Profile = value;
    }

    /// <summary>What START would run; null while nothing is armed.</summary>
    public ArmedJob? Armed => _status.Arming.Armed;

    /// <summary>Where the controller is; null while none is connected.</summary>
    public string? Description => _watched.Connection?.Description;

    /// <summary>The serial line it is connected by; null for none or another link.</summary>
    public SerialAddress? Line => _watched.Address as SerialAddress;

    public MachineIdentity? Identity => _watched.Identity;

    /// <summary>True for a controller that lives in this process.</summary>
    public bool IsSimulation => _watched.Connection?.Simulator is not null;

    /// <summary>Where the work origins of machines are kept between two sessions; null: nowhere. A simulated machine ends with its connection, and so does what is known of it.</summary>
    public string? OriginsFolder { get; init; }

    /// <summary>The connected machine in this host's hands, with its work origins; null while none is connected.</summary>
    public MachineHold? Hold { get; private set; }

    public bool IsRunning => _work.Stop is not null;

    /// <summary>The last word of the job under way or just ended; null before the first.</summary>
    public JobProgress? Progress { get; private set; }

    public MachineRunReport? LastRun { get; private set; }

    /// <summary>Shakes hands with a controller and watches it from then on; one that was connected before is let go.</summary>
    /// <exception cref="ControllerException">Nobody answers there.</exception>
    /// <exception cref="InvalidOperationException">A job runs.</exception>
    public async Task<MachineIdentity> ConnectAsync(ControllerAddress address, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(address);
        if (IsRunning) throw new InvalidOperationException("A job runs.");
        await DisconnectAsync().ConfigureAwait(false);
        var poll = await _watched.OpenAsync(address, cancellation).ConfigureAwait(false);
        var identity = _watched.Identity!;
        await TakeAsync(identity, cancellation).ConfigureAwait(false);
        _status.Connected(_watched.Connection!.Description, IsSimulation, identity);
        _status.Placed(Hold?.Memory.ActiveOrigin?.Plane);
        _status.Seen(poll);
        _watched.Resume();
        return identity;
    }

    /// <summary>The machine is taken before anybody is told that it is connected; when another host has it, the connection is let go.</summary>
    private async Task TakeAsync(MachineIdentity identity, CancellationToken cancellation)
    {
        try
        {
            var place = _place = await _watched.Watch!.LocateAsync(Profile.Axes, cancellation).ConfigureAwait(false);
            Hold = new MachineMemories(IsSimulation ? null : OriginsFolder).Take(_watched.Connection!.Description, identity, place, MachineHolder.Describe("CncEngraver", _time));
        }
        catch (ControllerException)
        {
            await DisconnectAsync().ConfigureAwait(false);
            throw;
        }
    }

    /// <summary>Lets the controller go; nothing when none is connected.</summary>
    public async Task DisconnectAsync()
    {
        Hold?.Dispose();
        (Hold, _place) = (null, null);
        if (_watched.Take() is not var (connection, watch)) return;
        _status.Disconnected();
        if (watch is not null) await watch.DisposeAsync().ConfigureAwait(false);
        await connection.DisposeAsync().ConfigureAwait(false);
        RaiseChanged();
    }

    /// <summary>Lets START work for a minute, or until the machine or what was prepared changes.</summary>
    /// <exception cref="InvalidOperationException">Something on the checklist has not passed.</exception>
    public ArmedJob Arm(PreparedJob job, JobMode mode, bool dryRun, ArmingChecklist checklist)
    {
        ArgumentNullException.ThrowIfNull(checklist);
        return checklist.Passed && Status.State is MachineState.Ready or MachineState.Armed
            ? _status.Arming.Arm(job, mode, dryRun, checklist)
            : throw new InvalidOperationException("What was not checked cannot be armed.");
    }

    /// <summary>Takes START back.</summary>
    /// <returns>False when nothing was armed.</returns>
    public bool Disarm() => _status.Arming.Disarm();

    /// <summary>A program as it can be run over the link that stands.</summary>
    public LinkFeedFit FitToLink(MotionProgram program, JobMode mode, Drawing drawing) => JobPlan.FitToLink(program, _watched.Address, mode, drawing);

    /// <summary>The axes of a connected machine are told to brake; a job under way has a stop of its own (<see cref="Stop"/>).</summary>
    public Task BrakeAsync() => IsRunning ? Task.CompletedTask : _watched.StopAsync(Profile.ToolOutput);

    /// <summary>Runs a job on the connected controller. One at a time.</summary>
    /// <param name="options">How; the address is that of the session.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public async Task<MachineRunReport> RunAsync(PreparedJob job, MotionProgram program, Func<ControllerAddress, MachineRunOptions> options, CancellationToken cancellation)
    {
        if (_watched is not { Connection: { } connection, Address: { } address }) throw new InvalidOperationException("No controller is connected.");
        return await WithStopAsync(stop => RunWatchedAsync(connection, job, program, options(address), stop), cancellation).ConfigureAwait(false);
    }

    /// <summary>Where the active work origin puts a job on the connected machine, asked of the controller now.</summary>
    /// <returns>Null while none is connected, or while a job has the wire.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<PlacementResult?> PlaceAsync(MotionProgram program, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(program);
        if (_watched.Watch is not { } watch || Hold is not { } hold) return null;
        var place = _place = await watch.LocateAsync(Profile.Axes, cancellation).ConfigureAwait(false);
        return WorkPlacement.Find(hold.Memory, place, new OriginRequest.Work(), program.Profile, program.Start);
    }

    /// <summary>The same by what the watch saw last, for a list that is shown all the time; nothing is asked.</summary>
    /// <returns>Null while no controller is connected, or before it was looked at.</returns>
    public PlacementResult? LastPlacement(MotionProgram program)
    {
        ArgumentNullException.ThrowIfNull(program);
        if (_place is not { } place || Hold is not { } hold || Status.MachinePosition is not { } at) return null;
        return WorkPlacement.Find(hold.Memory, place with { Mark = hold.Memory.Mark ?? place.Mark, Position = program.Profile.Scale.ToCounts(at) }, new OriginRequest.Work(), program.Profile, program.Start);
    }

    /// <summary>Changes the work origins, with the machine's position as the controller tells it now. Disarms.</summary>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed, or it cannot be kept.</exception>
    public async Task<MachineMemory> SetOriginAsync(Func<MachineMemory, ControllerPlace, MachineMemory> set, CancellationToken cancellation)
    {
        if (_watched.Watch is not { } watch || Hold is not { } hold || IsRunning) throw new InvalidOperationException("No controller is connected, or a job runs.");
        Disarm();
        var memory = await watch.SetOriginAsync(Profile.Axes, hold, set, cancellation).ConfigureAwait(false);
        _status.Placed(memory.ActiveOrigin?.Plane);
        RaiseChanged();
        return memory;
    }

    /// <summary>Jobs use another work origin from now on. Disarms.</summary>
    /// <param name="name">One of <see cref="WorkOriginNames"/>.</param>
    /// <returns>Why it could not be kept; null when it was.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    public string? ChooseOrigin(string name)
    {
        if (Hold is not { } hold || IsRunning) throw new InvalidOperationException("No controller is connected, or a job runs.");
        Disarm();
        var failure = hold.Keep(memory => memory with { Active = name });
        _status.Placed(hold.Memory.ActiveOrigin?.Plane);
        RaiseChanged();
        return failure;
    }

    /// <summary>Moves the connected machine with the tool off, at the profile's rapid speed, and disarms. It is stopped as a job is.</summary>
    /// <param name="goal">The controller's own counts.</param>
    /// <param name="journal">Where what is found in the controller is written down.</param>
    /// <param name="feed">Speed of each axis, mm/min; null for the profile's rapid speed.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public async Task<JobResult> GoToAsync(CountsPoint goal, string journal, double? feed, CancellationToken cancellation)
    {
        if (_watched.Connection is not { } connection) throw new InvalidOperationException("No controller is connected.");
        return await _work.RunAsync(stop => GoToWatchedAsync(connection, feed is { } speed ? Profile with { RapidMmPerMinute = speed } : Profile, goal, journal, stop), cancellation).ConfigureAwait(false);
    }

    /// <summary>Runs a job on a simulated controller of its own, at full speed; what is connected is left alone.</summary>
    /// <exception cref="InvalidOperationException">A job runs already.</exception>
    public async Task<MachineRunReport> SimulateAsync(PreparedJob job, MotionProgram program, Func<ControllerAddress, MachineRunOptions> options, CancellationToken cancellation)
    {
        var address = new SimulatedAddress(double.PositiveInfinity);
        await using var connection = MachineConnection.To(address, _time);
        return await WithStopAsync(stop => MachineRun.RunAsync(job, program, connection, options(address), _time, Listener(null), stop), cancellation).ConfigureAwait(false);
    }

    /// <summary>Stops the job under way: the machine brakes, the tool goes off, the job ends as stopped. With no job the axes of a connected machine brake all the same. Never waits, from any thread.</summary>
    /// <returns>False when no job runs.</returns>
    public bool Stop()
    {
        var (job, watch) = AtWork();
        if (job is not null) UrgentThread.Run(job.Cancel);
        else if (watch is not null) _watched.ActUrgently(watch, one => one.StopAsync(Profile.ToolOutput));
        _status.StopSent();
        return job is not null;
    }

    /// <summary>Halts every motion at once, without braking, and switches the motors off; a job ends as stopped. Never waits, from any thread.</summary>
    /// <remarks>On a serial line, whose one wire the job has, a job is stopped as by <see cref="Stop"/>: its axes brake, and the motors stay as they are.</remarks>
    public void Abort()
    {
        var (job, watch) = AtWork();
        if (watch is not null) _watched.ActUrgently(watch, one => one.AbortAsync(Profile.ToolOutput));
        if (job is not null) UrgentThread.Run(job.Cancel);
        _status.StopSent();
    }

    /// <summary>Switches the motors of both axes on or off.</summary>
    /// <returns>The refusal; null when it was done.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<MachineRefusal?> SetMotorsAsync(bool on, CancellationToken cancellation)
    {
        if (_watched.Watch is not { } watch || IsRunning) throw new InvalidOperationException("No controller is connected, or a job runs.");
        Disarm();
        var refused = await watch.SetMotorsAsync(on, cancellation).ConfigureAwait(false);
        if (refused is not null) _status.Refused(refused);
        Seen(await watch.LookAsync(cancellation).ConfigureAwait(false));
        return refused;
    }

    public async ValueTask DisposeAsync()
    {
        await _work.EndAsync().ConfigureAwait(false);
        await DisconnectAsync().ConfigureAwait(false);
        _status.Dispose();
    }

    private (CancellationTokenSource? Job, MachineWatch? Watch) AtWork()
    {
        _status.StopAsked();
        var watch = _watched.Watch;
        return (_work.Stop, watch); // in this order: a job that begins meanwhile is stopped as well
    }

    private Task<MachineRunReport> WithStopAsync(Func<CancellationToken, Task<MachineRunReport>> run, CancellationToken cancellation) => _work.RunAsync(
        async stop =>
        {
            Progress = null;
            return LastRun = await run(stop).ConfigureAwait(false);
        },
        cancellation);

    private async Task<MachineRunReport> RunWatchedAsync(MachineConnection connection, PreparedJob job, MotionProgram program, MachineRunOptions options, CancellationToken stop)
    {
        _status.JobBegins();
        await _watched.GiveWayAsync().ConfigureAwait(false);
        try
        {
            var report = await MachineRun.RunAsync(job, program, connection, options with { Hold = Hold, Placed = frame => _status.Placed(frame) }, _time, Listener(_status), stop).ConfigureAwait(false);
            _status.JobEnds(report.Result);
            return report;
        }
        finally
        {
            await _watched.ResumeAsync(connection).ConfigureAwait(false);
        }
    }

    private async Task<JobResult> GoToWatchedAsync(MachineConnection connection, MachineProfile profile, CountsPoint goal, string journal, CancellationToken stop)
    {
        _status.MoveBegins();
        await _watched.GiveWayAsync().ConfigureAwait(false);
        try
        {
            var result = await MachineMove.ToAsync(connection, Hold!, profile, _status.Here, goal, journal, new JobListener(TellMove), stop).ConfigureAwait(false);
            _status.MoveEnds(result);
            return result;
        }
        finally
        {
            await _watched.ResumeAsync(connection).ConfigureAwait(false);
        }
    }

    private void Seen(MachineReading poll)
    {
        while (_watched.Watch is { } watch && watch.TryTakeMessage(out var message)) Terminal.Add(TerminalAnswerKind.Message, message);
        KeepRest(poll);
        _status.Seen(poll);
    }

    /// <summary>Whoever moves the machine, a typed line or another host: where it rests is kept, for by that it is known after a power cycle whether its zero can be the same.</summary>
    private void KeepRest(MachineReading poll)
    {
        if (Hold is not { Memory: { Mark: not null } memory } hold || IsRunning) return;
        var at = new CountsPoint(poll.X, poll.Y);
        if (poll.Moves ? memory.IsMoving : !memory.IsMoving && memory.Rest == at) return;
        hold.Keep(before => before with { IsMoving = poll.Moves, Rest = poll.Moves ? null : at });
    }

    private async Task<IReadOnlyList<TerminalAnswer>> AnswerAsync(string line, CancellationToken cancellation)
    {
        if (_watched.Watch is not { } watch) return [new TerminalAnswer(TerminalAnswerKind.Withheld, Wording.Get("Common.NoControllerConnectedCncconnect"))];
        if (IsRunning) return [new TerminalAnswer(TerminalAnswerKind.Withheld, Wording.Get("MachineSession.JobRunsNothingSent"))];
        Disarm();
        var answers = await watch.AnswerAsync(line, cancellation).ConfigureAwait(false);
        if (answers.LastOrDefault(answer => answer.Kind == TerminalAnswerKind.Refusal) is { Text: { } refusal }) _status.NoteRefusal(refusal);
        return answers;
    }

    /// <param name="status">Null for a job that does not run on the connected machine.</param>
    private JobListener Listener(MachineStatusModel? status) => new(value =>
    {
        Progress = value;
        status?.JobTells(value);
        RaiseChanged();
    });

    private void TellMove(JobProgress value)
    {
        _status.MoveTells(value);
        RaiseChanged();
    }

    private void RaiseChanged() => Changed?.Invoke(this, EventArgs.Empty);
}
