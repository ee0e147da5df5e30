using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Machines;

/// <summary>The connection of a machine session and the watch that polls the controller while no job runs. Nothing is connected at first.</summary>
/// <remarks>Properties may be read from any thread; the session connects, disconnects and pauses for a job, one call after the other.</remarks>
/// <param name="axes">Those that a job would move, as the profile of the moment has them.</param>
internal sealed class WatchedConnection(TimeProvider time, Func<MachineAxes> axes, Action<MachineReading> seen, Action<ControllerException> lost)
{
    private readonly Lock _guard = new();
    private MachineWatch? _watch;

    /// <summary>Null while none is connected.</summary>
    public MachineConnection? Connection { get; private set; }

    public ControllerAddress? Address { get; private set; }

    public MachineIdentity? Identity { get; private set; }

    /// <summary>Null while none is connected, and on a single wire while a job has it.</summary>
    public MachineWatch? Watch
    {
        get
        {
            lock (_guard) return _watch;
        }
    }

    /// <summary>Shakes hands and looks once; watching begins with <see cref="ResumeAsync"/> or <see cref="Resume"/>.</summary>
    /// <param name="profile">Where the switches of a simulated machine lie.</param>
    /// <exception cref="ControllerException">Nobody answers there; nothing is connected then.</exception>
    public async Task<MachineReading> OpenAsync(MachineFamily family, ControllerAddress address, MachineProfile profile, CancellationToken cancellation)
    {
        var connection = family.Connect(address, time, false, profile);
        MachineWatch? watch = null;
        try
        {
            watch = await MachineWatch.OpenAsync(connection, axes, time, cancellation).ConfigureAwait(false);
            var poll = await watch.LookAsync(cancellation).ConfigureAwait(false);
            lock (_guard) (Connection, Address, Identity, _watch) = (connection, address, watch.Identity, watch);
            return poll;
        }
        finally
        {
            if (Identity is null && watch is not null) await watch.DisposeAsync().ConfigureAwait(false);
            if (Identity is null) await connection.DisposeAsync().ConfigureAwait(false);
        }
    }

    /// <summary>Begins to poll the controller.</summary>
    public void Resume() => Watch?.Resume(seen, lost);

    /// <summary>From now on nothing is connected; what was is still open and is the caller's.</summary>
    /// <returns>Null when nothing was connected.</returns>
    public (MachineConnection Connection, MachineWatch? Watch)? Take()
    {
        lock (_guard)
        {
            if (Connection is not { } connection) return null;
            var watch = _watch;
            (Connection, Address, Identity, _watch) = (null, null, null, null);
            return (connection, watch);
        }
    }

    /// <summary>Pauses the watch for a job; on a single wire closes it.</summary>
    public async Task GiveWayAsync()
    {
        if (Watch is not { } watch) return;
        await watch.PauseAsync().ConfigureAwait(false);
        if (!watch.IsSingleWire) return;
        lock (_guard) _watch = null;
        await watch.DisposeAsync().ConfigureAwait(false);
    }

    /// <summary>After a job the machine is watched again; a watch that was lost with the job's link is opened anew, once.</summary>
    public async Task ResumeAsync(MachineConnection connection)
    {
        try
        {
            seen(await LookAgainAsync().ConfigureAwait(false) ?? await LookAnewAsync(connection).ConfigureAwait(false));
            Resume();
        }
        catch (ControllerException failure)
        {
            lost(failure);
        }
    }

    /// <summary>One look after a pause, which shows whether the link was cut meanwhile.</summary>
    /// <returns>Null when it is lost.</returns>
    private async Task<MachineReading?> LookAgainAsync()
    {
        try
        {
            return Watch is { IsBroken: false } watch ? await watch.LookAsync(CancellationToken.None).ConfigureAwait(false) : null;
        }
        catch (ControllerException)
        {
            return null;
        }
    }

    private async Task<MachineReading> LookAnewAsync(MachineConnection connection)
    {
        if (Watch is { } broken) await broken.DisposeAsync().ConfigureAwait(false);
        var watch = await MachineWatch.OpenAsync(connection, axes, time, CancellationToken.None).ConfigureAwait(false);
        lock (_guard) _watch = watch;
        return await watch.LookAsync(CancellationToken.None).ConfigureAwait(false);
    }

    /// <summary>Runs an act over the watch without waiting for it; a failure is reported if that watch is still in use.</summary>
    public void ActUrgently(MachineWatch watch, Func<MachineWatch, Task> act) => UrgentThread.Run(() => _ = UrgentlyAsync(watch, act));

    /// <summary>Brakes the axes and switches the tool off; does nothing without a watch. A failure is reported.</summary>
    public Task StopAsync(IReadOnlyList<OutputSwitch> outputs) => Watch is { } watch ? UrgentlyAsync(watch, one => one.StopAsync(outputs)) : Task.CompletedTask;

    private async Task UrgentlyAsync(MachineWatch watch, Func<MachineWatch, Task> act)
    {
        try
        {
            await act(watch).ConfigureAwait(false);
        }
        catch (ControllerException failure)
        {
            if (ReferenceEquals(watch, Watch)) lost(failure);
        }
    }
}

/// <summary>A thread for one act that must not wait for the caller, the window's thread or a busy pool.</summary>
internal static class UrgentThread
{
    /// <summary>Begins the act at once and returns.</summary>
    public static void Run(Action act) => new Thread(() => act()) { IsBackground = true, Name = "stop", Priority = ThreadPriority.Highest }.Start();
}
