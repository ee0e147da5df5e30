using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Machines;

/// <summary>The connection of a machine session, with the polling of the controller while no job runs. Initially not connected.</summary>
/// <remarks>Properties may be read from any thread; the session connects, disconnects and pauses for a job, one call at a time.</remarks>
/// <param name="axes">The axes of the current profile.</param>
internal sealed class WatchedConnection(TimeProvider time, Func<MachineAxes> axes, Action<MachineReading> seen, Action<ControllerException> lost)
{
    private readonly Lock _guard = new();
    private MachinePoller? _watch;

    /// <summary>Null if not connected.</summary>
    public MachineConnection? Connection { get; private set; }

    public ControllerAddress? Address { get; private set; }

    public MachineIdentity? Identity { get; private set; }

    /// <summary>Null if not connected, and on a single connection during a job.</summary>
    public MachinePoller? Watch
    {
        get
        {
            lock (_guard) return _watch;
        }
    }

    /// <summary>Performs the handshake and polls once; periodic polling starts with <see cref="ResumeAsync"/> or <see cref="Resume"/>.</summary>
    /// <param name="profile">Defines the switches of a simulated machine.</param>
    /// <exception cref="ControllerException">The controller does not answer; nothing is connected.</exception>
    public async Task<MachineReading> OpenAsync(MachineFamily family, ControllerAddress address, MachineProfile profile, CancellationToken cancellation)
    {
        var connection = family.Connect(address, time, false, profile);
        MachinePoller? watch = null;
        try
        {
            watch = await MachinePoller.OpenAsync(connection, axes, time, cancellation).ConfigureAwait(false);
            var poll = await watch.PollAsync(cancellation).ConfigureAwait(false);
            lock (_guard) (Connection, Address, Identity, _watch) = (connection, address, watch.Identity, watch);
            return poll;
        }
        finally
        {
            if (Identity is null && watch is not null) await watch.DisposeAsync().ConfigureAwait(false);
            if (Identity is null) await connection.DisposeAsync().ConfigureAwait(false);
        }
    }

    /// <summary>Starts polling the controller.</summary>
    public void Resume() => Watch?.Resume(seen, lost);

    /// <summary>Detaches the connection, which remains open and is owned by the caller.</summary>
    /// <returns>Null if not connected.</returns>
    public (MachineConnection Connection, MachinePoller? Watch)? Detach()
    {
        lock (_guard)
        {
            if (Connection is not { } connection) return null;
            var watch = _watch;
            (Connection, Address, Identity, _watch) = (null, null, null, null);
            return (connection, watch);
        }
    }

    /// <summary>Pauses polling for a job; closes it on a single connection.</summary>
    public async Task PauseAsync()
    {
        if (Watch is not { } watch) return;
        await watch.PauseAsync().ConfigureAwait(false);
        if (!watch.IsSingleWire) return;
        lock (_guard) _watch = null;
        await watch.DisposeAsync().ConfigureAwait(false);
    }

    /// <summary>Resumes polling after a job; if it was lost with the job's link, it is reopened once.</summary>
    public async Task ResumeAsync(MachineConnection connection)
    {
        try
        {
            seen(await PollAfterPauseAsync().ConfigureAwait(false) ?? await ReopenAsync(connection).ConfigureAwait(false));
            Resume();
        }
        catch (ControllerException failure)
        {
            lost(failure);
        }
    }

    /// <summary>Polls once after a pause, to detect a lost link.</summary>
    /// <returns>Null if it is lost.</returns>
    private async Task<MachineReading?> PollAfterPauseAsync()
    {
        try
        {
            return Watch is { IsBroken: false } watch ? await watch.PollAsync(CancellationToken.None).ConfigureAwait(false) : null;
        }
        catch (ControllerException)
        {
            return null;
        }
    }

    private async Task<MachineReading> ReopenAsync(MachineConnection connection)
    {
        if (Watch is { } broken) await broken.DisposeAsync().ConfigureAwait(false);
        var watch = await MachinePoller.OpenAsync(connection, axes, time, CancellationToken.None).ConfigureAwait(false);
        lock (_guard) _watch = watch;
        return await watch.PollAsync(CancellationToken.None).ConfigureAwait(false);
    }

    /// <summary>Runs an action on the polling connection without waiting for it; a failure is reported if that connection is still in use.</summary>
    public void RunUrgently(MachinePoller watch, Func<MachinePoller, Task> action) => UrgentThread.Run(() => _ = RunUrgentAsync(watch, action));

    /// <summary>Decelerates the axes and switches the tool off; does nothing without a polling connection. A failure is reported.</summary>
    public Task StopAsync(IReadOnlyList<OutputSwitch> outputs) => Watch is { } watch ? RunUrgentAsync(watch, one => one.StopAsync(outputs)) : Task.CompletedTask;

    private async Task RunUrgentAsync(MachinePoller watch, Func<MachinePoller, Task> action)
    {
        try
        {
            await action(watch).ConfigureAwait(false);
        }
        catch (ControllerException failure)
        {
            if (ReferenceEquals(watch, Watch)) lost(failure);
        }
    }
}
