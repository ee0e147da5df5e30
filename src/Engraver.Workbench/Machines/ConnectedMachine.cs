using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Machines.Terminals;

namespace Engraver.Workbench.Machines;

/// <summary>The controller that is connected: its address, its identity, the lease of the machine and the watch that polls it. Everything that uses the
/// controller passes through here, under the rules of <see cref="MotionInterlock"/>.</summary>
/// <remarks>While nothing moves, the controller is polled ten times a second over handles of the session's own. A motion has the controller for itself: the
/// watch is paused before it and resumed after it.</remarks>
public sealed class ConnectedMachine
{
    private readonly TimeProvider _time;
    private readonly MachineStatusModel _status;
    private readonly MotionInterlock _interlock;
    private readonly MachineTrail _trail;
    private readonly string? _originsFolder;
    private readonly bool _simulatedIsHomed;

    internal ConnectedMachine(TimeProvider time, MachineStatusModel status, MotionInterlock interlock, MachineTrail trail, string? originsFolder, bool simulatedIsHomed, MachineFamilies families)
    {
        (_time, _status, _interlock, _trail, _originsFolder, _simulatedIsHomed) = (time, status, interlock, trail, originsFolder, simulatedIsHomed);
        Families = families;
        Watched = new WatchedConnection(time, () => status.Profile.Axes, Poll, status.LinkLost);
        Terminal = new LiveTerminal(time, AnswerAsync);
    }

    /// <summary>The controller families that it can connect to.</summary>
    public MachineFamilies Families { get; }

    /// <summary>The address of the controller; null while none is connected.</summary>
    public string? Description => Watched.Connection?.Description;

    /// <summary>The serial line of the connection; null for none or another link.</summary>
    public SerialAddress? Line => Watched.Address as SerialAddress;

    public MachineIdentity? Identity => Watched.Identity;

    /// <summary>True for a controller that lives in this process.</summary>
    public bool IsSimulation => Watched.Connection?.Simulator is not null;

    /// <summary>The lease of the connected machine, with its work origins; null while none is connected.</summary>
    public MachineLease? Lease => Located?.Lease;

    /// <summary>Whether the machine is homed; null for one without homing, or while none is connected.</summary>
    public bool? IsHomed => _status.Profile is { HasHoming: true } profile && Lease is { } lease ? lease.IsHomed(profile) : null;

    /// <summary>The lines of the terminal page.</summary>
    public LiveTerminal Terminal { get; }

    /// <summary>The links to the controller and the watch; stop and abort use them at any time.</summary>
    internal WatchedConnection Watched { get; }

    /// <summary>Null while none is connected.</summary>
    internal LocatedMachine? Located { get; private set; }

    /// <summary>Connects to a controller and watches it from then on; one that was connected before is disconnected.</summary>
    /// <exception cref="ControllerException">Nothing answers there.</exception>
    /// <exception cref="InvalidOperationException">A job runs.</exception>
    public async Task<MachineIdentity> ConnectAsync(ControllerAddress address, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(address);
        if (_interlock.IsRunning) throw new InvalidOperationException("A job runs.");
        await DisconnectAsync().ConfigureAwait(false);
        var poll = await Watched.OpenAsync(Families.At(address, _status.Profile), address, _simulatedIsHomed ? _status.Profile.WithoutHoming() : _status.Profile, cancellation).ConfigureAwait(false);
        var identity = Watched.Identity!;
        await LeaseAsync(identity, cancellation).ConfigureAwait(false);
        _status.Connected(Watched.Connection!.Description, IsSimulation, identity);
        _status.SetFrame(Lease?.Memory.ActiveOrigin?.Plane);
        Poll(poll);
        Watched.Resume();
        return identity;
    }

    /// <summary>Disconnects the controller; does nothing when none is connected. A motion under way is stopped first.</summary>
    public async Task DisconnectAsync()
    {
        await _interlock.FreeAsync().ConfigureAwait(false);
        await _interlock.EndAsync().ConfigureAwait(false);
        Located?.Dispose();
        Located = null;
        _trail.Clear();
        if (Watched.Detach() is not var (connection, watch)) return;
        _status.Disconnected();
        if (watch is not null) await watch.DisposeAsync().ConfigureAwait(false);
        await connection.DisposeAsync().ConfigureAwait(false);
        _status.RaiseChanged();
    }

    /// <summary>The program with its feed fitted to the present link.</summary>
    public LinkFeedFit FitToLink(MotionProgram program, ExecutionStrategy strategy, Drawing drawing) => JobPlan.FitToLink(program, Watched.Address, strategy, drawing);

    /// <summary>The watch of a controller that nothing else uses.</summary>
    /// <returns>Null while none is connected, or while a motion is under way.</returns>
    internal async Task<MachinePoller?> FindIdleAsync()
    {
        await _interlock.FreeAsync().ConfigureAwait(false);
        return _interlock.IsRunning ? null : Watched.Watch;
    }

    /// <summary>The watch of a controller that nothing else uses.</summary>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    internal async Task<MachinePoller> IdleAsync() => await FindIdleAsync().ConfigureAwait(false) ?? throw new InvalidOperationException("No controller is connected, or a job runs.");

    /// <summary>Ends a standby and gives the connection to the controller.</summary>
    /// <exception cref="InvalidOperationException">No controller is connected.</exception>
    internal async Task<MachineConnection> FreeAsync()
    {
        await _interlock.FreeAsync().ConfigureAwait(false);
        return Watched.Connection ?? throw new InvalidOperationException("No controller is connected.");
    }

    /// <summary>Makes a move by hand.</summary>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    internal Task<JobResult> MoveAsync(MachineProfile profile, MachineMove move, CancellationToken cancellation) =>
        MoveAsync(move.Doing, (connection, stop) => move.RunAsync(connection, Lease!, profile, _status.Position, stop), cancellation);

    /// <summary>Makes a move by hand.</summary>
    /// <param name="doing">The name of the move, for the status.</param>
    internal Task<JobResult> MoveAsync(string doing, Func<MachineConnection, CancellationToken, Task<JobResult>> move, CancellationToken cancellation) => UseAsync(
        () => _status.MoveStarted(doing),
        async (connection, stop) =>
        {
            var result = await move(connection, stop).ConfigureAwait(false);
            _status.MoveEnded(result);
            return result;
        },
        cancellation);

    /// <summary>Gives the controller to a job or a move, which then has it for itself.</summary>
    /// <param name="begin">Called when the controller is reserved, before the watch is paused.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    internal async Task<T> UseAsync<T>(Action begin, Func<MachineConnection, CancellationToken, Task<T>> use, CancellationToken cancellation)
    {
        var connection = await FreeAsync().ConfigureAwait(false);
        return await UseAsync(connection, begin, use, cancellation).ConfigureAwait(false);
    }

    /// <summary>The same with a connection that the caller has freed (<see cref="FreeAsync"/>).</summary>
    internal Task<T> UseAsync<T>(MachineConnection connection, Action begin, Func<MachineConnection, CancellationToken, Task<T>> use, CancellationToken cancellation) => _interlock.RunAsync(
        async stop =>
        {
            begin();
            await Watched.PauseAsync().ConfigureAwait(false);
            _status.WatchPaused();
            try
            {
                return await use(connection, stop).ConfigureAwait(false);
            }
            finally
            {
                await Watched.ResumeAsync(connection).ConfigureAwait(false);
            }
        },
        cancellation);

    /// <summary>Asks the controller for its position.</summary>
    /// <returns>Null when the machine was disconnected meanwhile.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    internal async Task<(LocatedMachine Machine, ControllerPosition Place)?> LocateAsync(MachinePoller watch, CancellationToken cancellation)
    {
        if (Located is not { } located) return null;
        var place = await watch.LocateAsync(_status.Profile.Axes, cancellation).ConfigureAwait(false);
        located.Recognise(place);
        return (located, place);
    }

    /// <summary>Polls the controller once.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    internal async Task PollAsync(MachinePoller watch, CancellationToken cancellation) => Poll(await watch.PollAsync(cancellation).ConfigureAwait(false));

    /// <summary>Takes a poll of the controller.</summary>
    internal void Poll(MachineReading poll)
    {
        while (Watched.Watch is { } watch && watch.TryGetMessage(out var message)) Terminal.Add(TerminalAnswerKind.Message, message);
        Located?.Record(poll, _interlock.IsRunning, _status.Profile.Axes);
        _status.SetOriginMissing(Located?.WhyUnplaced(_status.Profile, poll.Position)); // a job under way is not polled: this is before or after it
        _status.SetHomed(IsHomed, Lease is { Memory.HomingIsAssumed: true });
        _status.Polled(poll);
    }

    /// <summary>Leases the machine before the connection is announced; when another host has the lease, the connection is closed.</summary>
    private async Task LeaseAsync(MachineIdentity identity, CancellationToken cancellation)
    {
        try
        {
            var place = await Watched.Watch!.LocateAsync(_status.Profile.Axes, cancellation).ConfigureAwait(false);
            var lease = new MachineMemories(IsSimulation ? null : _originsFolder).Acquire(Watched.Connection!.Description, identity, place, LeaseOwner.Describe("CncEngraver", _time));
            Located = new LocatedMachine(lease, place);
            lease.CompareZero(place);
            if (_simulatedIsHomed && IsSimulation) lease.AssumeHomed(_status.Profile);
        }
        catch (ControllerException)
        {
            await DisconnectAsync().ConfigureAwait(false);
            throw;
        }
    }

    private async Task<IReadOnlyList<TerminalAnswer>> AnswerAsync(string line, CancellationToken cancellation)
    {
        await _interlock.FreeAsync().ConfigureAwait(false);
        if (Watched.Watch is not { } watch) return [new TerminalAnswer(TerminalAnswerKind.Withheld, Wording.Get("Common.NotConnected"))];
        if (_interlock.IsRunning) return [new TerminalAnswer(TerminalAnswerKind.Withheld, Wording.Get("MachineSession.JobRunning"))];
        _status.Arming.Disarm();
        var answers = await watch.AnswerAsync(line, cancellation).ConfigureAwait(false);
        if (answers.LastOrDefault(answer => answer.Kind == TerminalAnswerKind.Refusal) is { Text: { } refusal }) _status.NoteRefusal(refusal);
        return answers;
    }
}
