using Engraver.Galil.Jobs;
using Engraver.Galil.Links;
using Engraver.Galil.Programs;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines;

/// <summary>The machine the operator works with: one controller, and what it is doing. The other of the two places that change over time.</summary>
/// <remarks>Between jobs no link is held; the address is, and a simulated controller lives on and keeps its position.</remarks>
public sealed class MachineSession(TimeProvider time) : IAsyncDisposable
{
    private readonly Lock _guard = new();
    private CancellationTokenSource? _job;
    private MachineConnection? _connection;
    private ControllerAddress? _address;

    /// <summary>Raised when a connection or a job begins or ends, and with each progress; on any thread.</summary>
    public event EventHandler? Changed;

    /// <summary>Where the controller is; null while none is connected.</summary>
    public string? Description => _connection?.Description;

    public ControllerIdentity? Identity { get; private set; }

    /// <summary>True for a controller that lives in this process.</summary>
    public bool IsSimulation => _connection?.Simulator is not null;

    public bool IsRunning
    {
        get
        {
            lock (_guard) return _job is not null;
        }
    }

    /// <summary>The last word of the job under way or just ended; null before the first.</summary>
    public JobProgress? Progress { get; private set; }

    public MachineRunReport? LastRun { get; private set; }

    /// <summary>Shakes hands with a controller and remembers it; one that was connected before is let go.</summary>
    /// <exception cref="ControllerException">Nobody answers there.</exception>
    /// <exception cref="NotSupportedException">The kind of address is not built yet.</exception>
    public async Task<ControllerIdentity> ConnectAsync(ControllerAddress address, CancellationToken cancellation)
    {
        await DisconnectAsync().ConfigureAwait(false);
        var connection = MachineConnection.To(address, time);
        try
        {
            await using var session = await ControllerSession.OpenAsync(connection.OpenLinkAsync, new SessionOptions(), time, cancellation).ConfigureAwait(false);
            Identity = session.Identity;
        }
        finally
        {
            if (Identity is null) await connection.DisposeAsync().ConfigureAwait(false);
        }

        (_connection, _address) = (connection, address);
        Changed?.Invoke(this, EventArgs.Empty);
        return Identity;
    }

    /// <summary>Lets the controller go; nothing when none is connected.</summary>
    public async Task DisconnectAsync()
    {
        var connection = _connection;
        (_connection, _address, Identity) = (null, null, null);
        if (connection is null) return;
        await connection.DisposeAsync().ConfigureAwait(false);
        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Runs a job on the connected controller. One at a time.</summary>
    /// <param name="options">How; the address is that of the session.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public Task<MachineRunReport> RunAsync(PreparedJob job, MotionProgram program, Func<ControllerAddress, MachineRunOptions> options, CancellationToken cancellation) =>
        _connection is { } connection && _address is { } address
            ? RunOnAsync(connection, job, program, options(address), cancellation)
            : throw new InvalidOperationException("No controller is connected.");

    /// <summary>Runs a job on a simulated controller of its own, at full speed; what is connected is left alone.</summary>
    /// <exception cref="InvalidOperationException">A job runs already.</exception>
    public async Task<MachineRunReport> SimulateAsync(PreparedJob job, MotionProgram program, Func<ControllerAddress, MachineRunOptions> options, CancellationToken cancellation)
    {
        var address = new SimulatedAddress(double.PositiveInfinity);
        await using var connection = MachineConnection.To(address, time);
        return await RunOnAsync(connection, job, program, options(address), cancellation).ConfigureAwait(false);
    }

    /// <summary>Stops the job under way: the machine brakes, the job ends as stopped.</summary>
    /// <returns>False when no job runs.</returns>
    public bool Stop()
    {
        lock (_guard)
        {
            _job?.Cancel();
            return _job is not null;
        }
    }

    public ValueTask DisposeAsync()
    {
        Stop();
        return _connection?.DisposeAsync() ?? ValueTask.CompletedTask;
    }

    private async Task<MachineRunReport> RunOnAsync(MachineConnection connection, PreparedJob job, MotionProgram program, MachineRunOptions options, CancellationToken cancellation)
    {
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        Begin(stop);
        try
        {
            LastRun = await MachineRun.RunAsync(job, program, connection, options, time, new Listener(this), stop.Token).ConfigureAwait(false);
            return LastRun;
        }
        finally
        {
            lock (_guard) _job = null;
            Changed?.Invoke(this, EventArgs.Empty);
        }
    }

    private void Begin(CancellationTokenSource stop)
    {
        lock (_guard)
        {
            if (_job is not null) throw new InvalidOperationException("A job runs already.");
            _job = stop;
        }

        Progress = null;
        Changed?.Invoke(this, EventArgs.Empty);
    }

    private sealed class Listener(MachineSession session) : IProgress<JobProgress>
    {
        public void Report(JobProgress value)
        {
            session.Progress = value;
            session.Changed?.Invoke(session, EventArgs.Empty);
        }
    }
}
