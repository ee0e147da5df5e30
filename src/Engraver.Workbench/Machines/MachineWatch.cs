using System.Diagnostics.CodeAnalysis;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Machines.Setup;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>Handles of its own by which a connected controller is looked at while no job runs, and by which a stop, an abort and a typed line reach
/// it.</summary>
/// <remarks>While a job runs the watch is paused: the job polls, and nothing is asked twice. A serial line has one wire only: there the watch is closed for
/// the job.</remarks>
internal sealed class MachineWatch : IAsyncDisposable
{
    private static readonly TimeSpan s_interval = TimeSpan.FromMilliseconds(100);

    private readonly IMachineConnection _machine;
    private readonly TimeProvider _time;
    private CancellationTokenSource? _stopLooking;
    private Task _looking = Task.CompletedTask;

    private readonly Func<MachineAxes> _axes;

    private MachineWatch(IMachineConnection machine, Func<MachineAxes> axes, TimeProvider time) => (_machine, _axes, _time) = (machine, axes, time);

    public MachineIdentity Identity => _machine.Identity;

    /// <summary>True on a link that cannot carry the watch and a job together.</summary>
    public bool IsSingleWire => _machine.Capabilities.IsSingleWire;

    public bool IsBroken => _machine.IsBroken;

    /// <summary>Null where the controller's wiring cannot be told.</summary>
    public IMachineSetup? Setup => _machine.Setup;

    /// <param name="axes">Those that a job would move, as the profile of the moment has them.</param>
    /// <exception cref="ControllerException">Nobody answers.</exception>
    public static async Task<MachineWatch> OpenAsync(MachineConnection connection, Func<MachineAxes> axes, TimeProvider time, CancellationToken cancellation) =>
        new(await connection.ShakeHandsAsync(time, cancellation).ConfigureAwait(false), axes, time);

    /// <summary>One look, now.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public ValueTask<MachineReading> LookAsync(CancellationToken cancellation) => _machine.LookAsync(_axes(), cancellation);

    /// <summary>Where the machine stands and whether it still counts from the same zero.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public ValueTask<ControllerPlace> LocateAsync(MachineAxes axes, CancellationToken cancellation) => _machine.LocateAsync(axes, cancellation);

    /// <summary>Sets a work origin by where the machine stands.</summary>
    /// <returns>Why not; null when it was set.</returns>
    /// <exception cref="ControllerException">The link failed, or it cannot be kept.</exception>
    public Task<Diagnostic?> SetOriginAsync(MachineProfile profile, MachineHold hold, Func<MachineMemory, ControllerPlace, MachineMemory> set, CancellationToken cancellation) => JobPlacement.SetOriginAsync(_machine, profile, hold, set, _time, cancellation);

    /// <summary>Looks ten times a second until <see cref="PauseAsync"/>, or until the link fails.</summary>
    public void Resume(Action<MachineReading> seen, Action<ControllerException> lost)
    {
        _stopLooking = new CancellationTokenSource();
        _looking = LookOnAsync(seen, lost, _stopLooking.Token);
    }

    /// <summary>Stops looking; returns when the last question has been answered.</summary>
    public async Task PauseAsync()
    {
        if (_stopLooking is not { } looking) return;
        _stopLooking = null;
        await looking.CancelAsync().ConfigureAwait(false);
        await _looking.ConfigureAwait(false);
        looking.Dispose();
    }

    /// <summary>Takes the next text that programs of the controller have printed.</summary>
    public bool TryTakeMessage([NotNullWhen(true)] out string? message) => _machine.TryTakeMessage(out message);

    /// <summary>The operator's typed line.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public Task<IReadOnlyList<TerminalAnswer>> AnswerAsync(string line, CancellationToken cancellation) => _machine.AnswerAsync(line, cancellation);

    /// <summary>Where an interrupted job is to go on.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public Task<ResumePlace> FindResumeAsync(MotionProgram program, ExecutionStrategy strategy, string journal, CancellationToken cancellation) => _machine.FindResumeAsync(program, strategy, journal, cancellation);

    /// <summary>Tool off, the path and every axis brake.</summary>
    public Task StopAsync(IReadOnlyList<OutputSwitch> outputs) => _machine.StopAsync(outputs);

    /// <summary>Every motion halts at once and every program ends, tool off, motors off.</summary>
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

    private async Task LookOnAsync(Action<MachineReading> seen, Action<ControllerException> lost, CancellationToken cancellation)
    {
        try
        {
            while (!cancellation.IsCancellationRequested)
            {
                await Task.Delay(s_interval, _time, cancellation).ConfigureAwait(false);
                seen(await LookAsync(cancellation).ConfigureAwait(false));
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
