using System.Collections.Concurrent;
using System.Globalization;
using Engraver.Galil.Links;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Workbench.Machines.Terminals;

namespace Engraver.Workbench.Machines;

/// <summary>Handles of its own by which a connected controller is looked at while no job runs, and by which a stop, an abort and a typed line reach it.</summary>
/// <remarks>While a job runs the watch is paused: the job polls, and nothing is asked twice. A serial line has one wire only: there the watch is closed for the job.</remarks>
internal sealed class MachineWatch : IAsyncDisposable
{
    private static readonly TimeSpan s_interval = TimeSpan.FromMilliseconds(100);

    private readonly ControllerSession _session;
    private readonly ConcurrentQueue<string> _messages;
    private readonly TimeProvider _time;
    private CancellationTokenSource? _stopLooking;
    private Task _looking = Task.CompletedTask;

    private MachineWatch(ControllerSession session, ConcurrentQueue<string> messages, TimeProvider time)
    {
        _session = session;
        _messages = messages;
        _time = time;
        Conversation = MachineTerminal.On(session, messages);
    }

    public ControllerIdentity Identity => _session.Identity;

    /// <summary>True on a link that cannot carry the watch and a job together.</summary>
    public bool IsSingleWire => _session.Line is not null;

    public bool IsBroken => _session.StopHandle.IsBroken;

    /// <summary>The operator's typed lines over the handle for commands.</summary>
    public MachineTerminal Conversation { get; }

    /// <exception cref="ControllerException">Nobody answers.</exception>
    public static async Task<MachineWatch> OpenAsync(MachineConnection connection, TimeProvider time, CancellationToken cancellation)
    {
        var messages = new ConcurrentQueue<string>();
        var session = await ControllerSession.OpenAsync(connection.OpenLinkAsync, new SessionOptions { MessageReceived = messages.Enqueue }, time, cancellation).ConfigureAwait(false);
        return new MachineWatch(session, messages, time);
    }

    /// <summary>One look, now.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public ValueTask<MachinePoll> LookAsync(CancellationToken cancellation) => MachinePoll.ReadAsync(_session.StopHandle, cancellation);

    /// <summary>Looks ten times a second until <see cref="PauseAsync"/>, or until the link fails.</summary>
    public void Resume(Action<MachinePoll> seen, Action<ControllerException> lost)
    {
        _stopLooking = new CancellationTokenSource();
        _looking = LookOnAsync(seen, lost, _stopLooking.Token);
    }

    /// <summary>Returns when nothing is asked any more.</summary>
    public async Task PauseAsync()
    {
        if (_stopLooking is not { } looking) return;
        _stopLooking = null;
        await looking.CancelAsync().ConfigureAwait(false);
        await _looking.ConfigureAwait(false);
        looking.Dispose();
    }

    /// <summary>Text that programs have printed since the last time.</summary>
    public bool TryTakeMessage(out string? message) => _messages.TryDequeue(out message);

    /// <summary>Sends commands one after the other over the handle of the stop; a refused one does not keep the next from being tried.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task SendUrgentlyAsync(params IReadOnlyList<string> commands)
    {
        foreach (var command in commands) await _session.StopHandle.SendAsync(command, CancellationToken.None).ConfigureAwait(false);
    }

    /// <summary>Tool off, the path and every axis brake.</summary>
    public Task StopAsync(int toolOutput) => SendUrgentlyAsync(ToolOff(toolOutput), "STS", $"ST {_session.Identity.Letters}");

    /// <summary>Every motion halts at once and every program ends, tool off, motors off.</summary>
    public Task AbortAsync(int toolOutput) => SendUrgentlyAsync("AB", ToolOff(toolOutput), $"MO{_session.Identity.Letters}");

    /// <summary>Switches the motors of both axes.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<Rejected?> SetMotorsAsync(bool on, CancellationToken cancellation) =>
        await _session.Commands.SendAsync(on ? "SHAB" : "MOAB", cancellation).ConfigureAwait(false) as Rejected;

    public async ValueTask DisposeAsync()
    {
        await PauseAsync().ConfigureAwait(false);
        await _session.DisposeAsync().ConfigureAwait(false);
    }

    private static string ToolOff(int output) => string.Create(CultureInfo.InvariantCulture, $"CB {output}");

    private async Task LookOnAsync(Action<MachinePoll> seen, Action<ControllerException> lost, CancellationToken cancellation)
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
