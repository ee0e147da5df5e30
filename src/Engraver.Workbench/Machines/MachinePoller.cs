using System.Diagnostics.CodeAnalysis;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Machines.Setup;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>Separate handles that poll a connected controller while no job runs, and that carry stop, abort and typed lines.</summary>
/// <remarks>Polling is paused during a job, because the job polls. A serial line has only one connection: there it is closed for the job.</remarks>
internal sealed class MachinePoller : IAsyncDisposable
{
    private static readonly TimeSpan s_interval = TimeSpan.FromMilliseconds(100);

    private readonly IMachineConnection _machine;
    private readonly TimeProvider _time;
    private CancellationTokenSource? _stopPolling;
    private Task _polling = Task.CompletedTask;

    private readonly Func<MachineAxes> _axes;

    private MachinePoller(IMachineConnection machine, Func<MachineAxes> axes, TimeProvider time) => (_machine, _axes, _time) = (machine, axes, time);

    public MachineIdentity Identity => _machine.Identity;

    /// <summary>True if the link cannot carry polling and a job at the same time.</summary>
    public bool IsSingleWire => _machine.Capabilities.IsSingleWire;

    public bool IsBroken => _machine.IsBroken;

    /// <summary>Null if the controller does not support wiring settings.</summary>
    public IMachineSetup? Setup => _machine.Setup;

    /// <param name="axes">The axes of the current profile.</param>
    /// <exception cref="ControllerException">The controller does not answer.</exception>
    public static async Task<MachinePoller> OpenAsync(MachineConnection connection, Func<MachineAxes> axes, TimeProvider time, CancellationToken cancellation) =>
        new(await connection.HandshakeAsync(time, cancellation).ConfigureAwait(false), axes, time);

    /// <summary>Polls the controller once.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public ValueTask<MachineReading> PollAsync(CancellationToken cancellation) => _machine.ReadStatusAsync(_axes(), cancellation);

    /// <summary>Returns the position and whether the controller's zero is unchanged.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public ValueTask<ControllerPosition> LocateAsync(MachineAxes axes, CancellationToken cancellation) => _machine.ReadPositionAsync(axes, cancellation);

    /// <summary>Sets a work origin at the current position.</summary>
    /// <returns>Why it was not set; null on success.</returns>
    /// <exception cref="ControllerException">The link failed, or the origin cannot be stored.</exception>
    public Task<Diagnostic?> SetOriginAsync(MachineProfile profile, MachineLease lease, Func<StoredMachineState, ControllerPosition, StoredMachineState> set, CancellationToken cancellation) => JobPlacement.SetOriginAsync(_machine, profile, lease, set, _time, cancellation);

    /// <summary>Polls ten times a second until <see cref="PauseAsync"/> or until the link fails.</summary>
    public void Resume(Action<MachineReading> seen, Action<ControllerException> lost)
    {
        _stopPolling = new CancellationTokenSource();
        _polling = PollLoopAsync(seen, lost, _stopPolling.Token);
    }

    /// <summary>Stops polling; returns after the last reply.</summary>
    public async Task PauseAsync()
    {
        if (_stopPolling is not { } looking) return;
        _stopPolling = null;
        await looking.CancelAsync().ConfigureAwait(false);
        await _polling.ConfigureAwait(false);
        looking.Dispose();
    }

    /// <summary>Removes the next text printed by controller programs.</summary>
    public bool TryGetMessage([NotNullWhen(true)] out string? message) => _machine.TryTakeMessage(out message);

    /// <summary>Sends a line typed by the operator.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public Task<IReadOnlyList<TerminalAnswer>> AnswerAsync(string line, CancellationToken cancellation) => _machine.ExecuteLineAsync(line, cancellation);

    /// <summary>Finds the resume position of an interrupted job.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public Task<ResumePosition> FindResumeAsync(MotionProgram program, ExecutionStrategy strategy, string journal, CancellationToken cancellation) => _machine.FindResumeAsync(program, strategy, journal, cancellation);

    /// <summary>Switches the tool off and decelerates the path and every axis.</summary>
    public Task StopAsync(IReadOnlyList<OutputSwitch> outputs) => _machine.StopAsync(outputs);

    /// <summary>Halts every motion without deceleration, ends every program, switches tool and motors off.</summary>
    public Task AbortAsync(IReadOnlyList<OutputSwitch> outputs) => _machine.AbortAsync(outputs);

    /// <summary>Switches the motors of both axes.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public Task<MachineRefusal?> SetMotorsAsync(bool on, CancellationToken cancellation) => _machine.SetMotorsAsync(_axes(), on, cancellation);

    /// <summary>Switches one output.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public Task<MachineRefusal?> SetOutputAsync(int output, bool on, CancellationToken cancellation) => _machine.SetOutputAsync(output, on, cancellation);

    public async ValueTask DisposeAsync()
    {
        await PauseAsync().ConfigureAwait(false);
        await _machine.DisposeAsync().ConfigureAwait(false);
    }

    private async Task PollLoopAsync(Action<MachineReading> seen, Action<ControllerException> lost, CancellationToken cancellation)
    {
        try
        {
            while (!cancellation.IsCancellationRequested)
            {
                await Task.Delay(s_interval, _time, cancellation).ConfigureAwait(false);
                seen(await PollAsync(cancellation).ConfigureAwait(false));
            }
        }
        catch (OperationCanceledException)
        {
            // Paused.
        }
        catch (ControllerException failure)
        {
            lost(failure);
        }
    }
}
