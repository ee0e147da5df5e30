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

/// <summary>The machine the operator works with: one controller, and what it is doing. One of the two objects that change over time (the other is the
/// document session).</summary>
/// <remarks>While connected the controller is looked at ten times a second over handles of the session's own; while a job runs the job tells. Status, stop
/// and abort may be used from any thread.</remarks>
public sealed partial class MachineSession : IAsyncDisposable
{
    private readonly TimeProvider _time;
    private readonly MachineStatusModel _status;
    private readonly ActiveJob _work;
    private readonly WatchedConnection _watched;
    private readonly OperatorOverrides _overrides = new();
    private ControllerPlace? _place;

    public MachineSession(TimeProvider time)
    {
        _time = time;
        _status = new MachineStatusModel(time, RaiseChanged);
        _watched = new WatchedConnection(time, () => Profile.Axes, Seen, _status.Lost);
        _work = new ActiveJob(_status.JobIsOver, RaiseChanged);
        Terminal = new LiveTerminal(time, AnswerAsync);
        Presence = new OperatorPresence(time, RaiseChanged);
    }

    /// <summary>Raised when a connection or a job begins or ends, with each look at the controller and each progress; on any thread.</summary>
    public event EventHandler? Changed;

    /// <summary>What is known of the machine now.</summary>
    public MachineStatus Status => _status.Status;

    public AlarmLog Alarms => _status.Alarms;

    /// <summary>Where the machine was last, also while no job runs.</summary>
    public MachineTrail Trail { get; } = new();

    /// <summary>The lines of the terminal page.</summary>
    public LiveTerminal Terminal { get; }

    /// <summary>Begins continuous jogs, and hears the front end's signs of life meanwhile.</summary>
    public OperatorPresence Presence { get; }

    /// <summary>The machine profile, by which counts become millimetres and the tool's output is known. Setting another one disarms.</summary>
    public MachineProfile Profile
    {
        get => _status.Profile;
        set => _status.Profile = value;
    }

    /// <summary>The job that START would run; null while nothing is armed.</summary>
    public ArmedJob? Armed => _status.Arming.Armed;

    /// <summary>The address of the controller; null while none is connected.</summary>
    public string? Description => _watched.Connection?.Description;

    /// <summary>The serial line it is connected by; null for none or another link.</summary>
    public SerialAddress? Line => _watched.Address as SerialAddress;

    public MachineIdentity? Identity => _watched.Identity;

    /// <summary>True for a controller that lives in this process.</summary>
    public bool IsSimulation => _watched.Connection?.Simulator is not null;

    /// <summary>A simulated machine counts as homed and stands at its machine zero: for one act on a machine that ends with it. Otherwise it is homed as a
    /// real one is.</summary>
    public bool SimulatedIsHomed { get; init; }

    /// <summary>The controller families that it can connect to.</summary>
    public MachineFamilies Families { get; init; } = MachineFamilies.Standard;

    /// <summary>Where the work origins of machines are kept between two sessions; null: nowhere. A simulated machine ends with its connection, and so does
    /// what is known of it.</summary>
    public string? OriginsFolder { get; init; }

    /// <summary>The reservation of the connected machine, with its work origins; null while none is connected.</summary>
    public MachineHold? Hold { get; private set; }

    /// <summary>A job or a move is under way.</summary>
    public bool IsRunning => _work.Stop is not null && !IsKeptReady;

    /// <summary>The last progress of the job under way or just ended; null before the first.</summary>
    public JobProgress? Progress { get; private set; }

    public MachineRunReport? LastRun { get; private set; }

    /// <summary>The job whose progress the status shows, under way or ended; null before the first and after <see cref="DismissJob"/>.</summary>
    public PreparedJob? ShownJob { get; private set; }

    /// <summary>What START would cut where it is not the whole drawing; null for all of it.</summary>
    public JobPart? Part { get; private set; }

    /// <summary>Chooses what START cuts. Disarms.</summary>
    /// <param name="part">Null for the whole drawing.</param>
    public void ChoosePart(JobPart? part)
    {
        if (Part == part) return;
        Disarm();
        Part = part;
        RaiseChanged();
    }

    /// <summary>Forgets the job that ended last, so that its progress is not shown with another drawing. Does nothing while a job runs.</summary>
    public void DismissJob()
    {
        if (IsRunning) return;
        ShownJob = null;
        _status.DismissJob();
        RaiseChanged();
    }

    /// <summary>Connects to a controller and watches it from then on; one that was connected before is disconnected.</summary>
    /// <exception cref="ControllerException">Nobody answers there.</exception>
    /// <exception cref="InvalidOperationException">A job runs.</exception>
    public async Task<MachineIdentity> ConnectAsync(ControllerAddress address, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(address);
        if (IsRunning) throw new InvalidOperationException("A job runs.");
        await DisconnectAsync().ConfigureAwait(false);
        var poll = await _watched.OpenAsync(Families.At(address, Profile), address, SimulatedIsHomed ? Profile.WithoutHoming() : Profile, cancellation).ConfigureAwait(false);
        var identity = _watched.Identity!;
        await TakeAsync(identity, cancellation).ConfigureAwait(false);
        _status.Connected(_watched.Connection!.Description, IsSimulation, identity);
        _status.Placed(Hold?.Memory.ActiveOrigin?.Plane);
        Seen(poll);
        _watched.Resume();
        return identity;
    }

    /// <summary>Reserves the machine before <see cref="Changed"/> is raised; when another host has it, the connection is closed.</summary>
    private async Task TakeAsync(MachineIdentity identity, CancellationToken cancellation)
    {
        try
        {
            var place = _place = await _watched.Watch!.LocateAsync(Profile.Axes, cancellation).ConfigureAwait(false);
            Hold = new MachineMemories(IsSimulation ? null : OriginsFolder).Take(_watched.Connection!.Description, identity, place, MachineHolder.Describe("CncEngraver", _time));
            Hold.Recognise(place);
            if (SimulatedIsHomed && IsSimulation) Hold.AssumeHomed(Profile);
        }
        catch (ControllerException)
        {
            await DisconnectAsync().ConfigureAwait(false);
            throw;
        }
    }

    /// <summary>Disconnects the controller; does nothing when none is connected.</summary>
    public async Task DisconnectAsync()
    {
        await FreeAsync().ConfigureAwait(false);
        Hold?.Dispose();
        (Hold, _place) = (null, null);
        Trail.Clear();
        if (_watched.Take() is not var (connection, watch)) return;
        _status.Disconnected();
        if (watch is not null) await watch.DisposeAsync().ConfigureAwait(false);
        await connection.DisposeAsync().ConfigureAwait(false);
        RaiseChanged();
    }

    /// <summary>Arms a job: START works for a minute, or until the machine, the drawing or a setting changes.</summary>
    /// <exception cref="InvalidOperationException">Something on the checklist has not passed.</exception>
    public ArmedJob Arm(PreparedJob job, ExecutionStrategy strategy, bool dryRun, ArmingChecklist checklist)
    {
        ArgumentNullException.ThrowIfNull(checklist);
        if (!checklist.Passed || !Status.State.IsReady()) throw new InvalidOperationException("What was not checked cannot be armed.");
        DismissJob();
        return _status.Arming.Arm(job, strategy, dryRun, checklist);
    }

    /// <summary>Disarms.</summary>
    /// <returns>False when nothing was armed.</returns>
    public bool Disarm() => _status.Arming.Disarm();

    /// <summary>The program with its feed fitted to the present link.</summary>
    public LinkFeedFit FitToLink(MotionProgram program, ExecutionStrategy strategy, Drawing drawing) => JobPlan.FitToLink(program, _watched.Address, strategy, drawing);

    public async ValueTask DisposeAsync()
    {
        await _work.EndAsync().ConfigureAwait(false);
        await DisconnectAsync().ConfigureAwait(false);
        _status.Dispose();
    }

    private Task<JobResult> MoveWatchedAsync(MachineConnection connection, MachineProfile profile, MachineMove move, CancellationToken stop) =>
        WatchedAsync(connection, move.Doing, () => move.RunAsync(connection, Hold!, profile, _status.Here, stop));

    /// <summary>A motion by hand, before which the watch makes way.</summary>
    /// <param name="doing">For the state, while it lasts.</param>
    private async Task<JobResult> WatchedAsync(MachineConnection connection, string doing, Func<Task<JobResult>> move)
    {
        _status.MoveBegins(doing);
        await _watched.GiveWayAsync().ConfigureAwait(false);
        try
        {
            var result = await move().ConfigureAwait(false);
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
        if (_place is { } known && !poll.Moves) Hold?.KeepStoppedHard(known with { Position = poll.Position }, poll.StoppedHard);
        if (!IsRunning) Hold?.KeepSeen(poll.Position, poll.Moves);
        if (_place is { } place && string.Concat(poll.MotorsOff.Intersect(place.Uncounted)) is { Length: > 0 } off) Hold?.KeepLost(Wording.Get("Origins.StepperWasOff", Profile.Axes.NamesOf(off)));
        _status.OriginIs(OriginMissing(poll.Position)); // a job under way is not watched: this is the look before or behind it
        _status.HomedIs(IsHomed, Hold is { Memory.HomingIsAssumed: true });
        _status.Seen(poll);
    }

    private async Task<IReadOnlyList<TerminalAnswer>> AnswerAsync(string line, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Watch is not { } watch) return [new TerminalAnswer(TerminalAnswerKind.Withheld, Wording.Get("Common.NotConnected"))];
        if (IsRunning) return [new TerminalAnswer(TerminalAnswerKind.Withheld, Wording.Get("MachineSession.JobRunning"))];
        Disarm();
        var answers = await watch.AnswerAsync(line, cancellation).ConfigureAwait(false);
        if (answers.LastOrDefault(answer => answer.Kind == TerminalAnswerKind.Refusal) is { Text: { } refusal }) _status.NoteRefusal(refusal);
        return answers;
    }

    /// <param name="status">Null for a job that does not run on the connected machine.</param>
    /// <param name="live">Null where the places are not collected meanwhile.</param>
    private JobListener Listener(MachineStatusModel? status, LiveTrace? live = null) => new(value =>
    {
        Progress = value;
        if (live?.Add(value) is { } sofar) Recorded = sofar;
        status?.JobTells(value);
        RaiseChanged();
    });

    private void TellMove(JobProgress value)
    {
        _status.MoveTells(value);
        RaiseChanged();
    }

    private void RaiseChanged()
    {
        if (Status is { IsLinkLost: false, MachinePosition: { } at }) Trail.Add(at);
        Changed?.Invoke(this, EventArgs.Empty);
    }
}
