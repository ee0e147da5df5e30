using System.Globalization;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>A connection to one controller: a handle for commands and, if the link allows, a second one for the stop and for unsolicited text.</summary>
/// <remarks>Disposing restores the controller's state, as far as possible when the link is lost. A job changes speeds and motors and calls
/// <see cref="RestoreAsync"/>.</remarks>
public sealed class ControllerSession : IAsyncDisposable
{
    private readonly CommandChannel _commands;
    private readonly Func<CancellationToken, Task<CommandChannel>> _openSecond;
    private volatile CommandChannel? _second;

    private ControllerSession(
        CommandChannel commands, CommandChannel? second, Func<CancellationToken, Task<CommandChannel>> openSecond, ControllerIdentity identity, FoundState found, TimeProvider time)
    {
        _commands = commands;
        _second = second;
        _openSecond = openSecond;
        Identity = identity;
        Found = found;
        Time = time;
    }

    /// <summary>What a connection that the controller drops at once means (galil-dmc.md A.1).</summary>
    public static string HandlesTaken => Wording.Get("ControllerSession.HandlesTaken");

    public ControllerIdentity Identity { get; }

    /// <summary>The state to restore at the end.</summary>
    public FoundState Found { get; private set; }

    /// <summary>The clock for all waits: the system's with a real controller, the controller's own with a simulated one that shares its clock.</summary>
    public TimeProvider Time { get; }

    /// <summary>The serial line for everything, including the stop; null for a link with two handles.</summary>
    public SerialLine? Line => _commands.Line;

    /// <summary>Measured time of an exchange, seconds (<see cref="RoundTrip"/>); null before it was measured.</summary>
    public double? ExchangeSeconds { get; set; }

    /// <summary>The handle for commands; the second handle when the link of the first is lost and the second still works.</summary>
    public CommandChannel Commands => _commands.IsBroken && _second is { IsBroken: false } ? _second : _commands;

    /// <summary>The handle for the operator's stop: it never waits for the sending of segments, and on a serial line only for the bytes that are being sent
    /// (<see cref="CommandChannel.SendUrgentAsync"/>).</summary>
    public CommandChannel StopHandle => _second is { IsBroken: false } ? _second : _commands;

    /// <summary>Opens both handles and identifies the controller (galil-dmc.md F.2). Changes only CW, CF, DR, the number format and, on a serial line, the
    /// echo.</summary>
    /// <param name="openLink">Opens one more link to the same controller; called twice if a second handle is requested.</param>
    /// <exception cref="ControllerException">No link, no reply, or not a controller.</exception>
    public static async Task<ControllerSession> OpenAsync(
        Func<CancellationToken, Task<IControllerLink>> openLink, SessionOptions options, TimeProvider time, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(openLink);
        ArgumentNullException.ThrowIfNull(options);
        CommandChannel? commands = null;
        CommandChannel? second = null;
        var opened = false;
        async Task<CommandChannel> Open(string name, CancellationToken giveUp) =>
            new(await openLink(giveUp).ConfigureAwait(false), name, options.ReplyTimeout, time, options.Trace) { MessageReceived = options.MessageReceived };
        try
        {
            commands = await Open("A", cancellation).ConfigureAwait(false);
            bool? echo = commands.Line is null ? null : await commands.GreetAsync(cancellation).ConfigureAwait(false);
            await CheckSecondHandleAsync(commands, cancellation).ConfigureAwait(false);
            if (options.SecondHandle && commands.Line is null) await CheckSecondHandleAsync(second = await Open("B", cancellation).ConfigureAwait(false), cancellation).ConfigureAwait(false);
            var identity = await Handshake.IdentifyAsync(commands, cancellation).ConfigureAwait(false);
            var found = await FoundState.ReadAsync(commands, identity.Letters, echo, cancellation).ConfigureAwait(false);
            var session = new ControllerSession(commands, second, giveUp => Open("B", giveUp), identity, found, time);
            await session.ConfigureLinkAsync(cancellation).ConfigureAwait(false);
            opened = true;
            return session;
        }
        finally
        {
            if (!opened && second is not null) await second.DisposeAsync().ConfigureAwait(false);
            if (!opened && commands is not null) await commands.DisposeAsync().ConfigureAwait(false);
        }
    }

    /// <summary>Opens the second handle. A controller without a free handle accepts a connection and closes it at once (galil-dmc.md A.1); the message must not
    /// suggest a disconnected cable.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    private static async Task CheckSecondHandleAsync(CommandChannel channel, CancellationToken cancellation)
    {
        try
        {
            await channel.SendAsync("", cancellation).ConfigureAwait(false);
        }
        catch (ControllerLinkException dropped)
        {
            throw new ControllerLinkException($"{dropped.Message} {HandlesTaken}", dropped);
        }
    }

    /// <summary>Tests the second handle, and opens it again if it is lost; in between the stop uses the first handle.</summary>
    /// <returns>Null when it works, and when there is no second handle.</returns>
    internal async Task<StopHandleLoss?> CheckStopHandleAsync(CancellationToken cancellation)
    {
        if (_second is not { } second) return null;
        try
        {
            await second.SendAsync("", cancellation).ConfigureAwait(false);
            return null;
        }
        catch (ControllerException lost)
        {
            await second.DisposeAsync().ConfigureAwait(false);
            return new StopHandleLoss(lost.Message.TrimEnd('.'), await ReopenAsync(cancellation).ConfigureAwait(false));
        }
    }

    /// <returns>Why it could not be opened; null when it is open again.</returns>
    private async Task<string?> ReopenAsync(CancellationToken cancellation)
    {
        try
        {
            var second = await _openSecond(cancellation).ConfigureAwait(false);
            await second.SendAsync("CF I", cancellation).ConfigureAwait(false);
            _second = second;
            return null;
        }
        catch (Exception failure) when (failure is ControllerException or IOException)
        {
            _second = null;
            return SystemErrorText.FromException(failure);
        }
    }

    /// <summary>Why no job can start now: a thread of another program runs, or something moves. Null when the machine is free.</summary>
    public async Task<string?> BusyReasonAsync(CancellationToken cancellation)
    {
        if (await IsOwnJobRunningAsync(cancellation).ConfigureAwait(false))
            return Wording.Get("ControllerSession.InUseByAnotherRun");
        for (var thread = 0; thread < 8; thread++)
        {
            var line = (await Commands.ReadAsync($"_XQ{thread}", cancellation).ConfigureAwait(false)).ValuesOrEmpty;
            if (line is >= 0) return Wording.Get("ControllerSession.ThreadRunning", thread, line);
        }

        foreach (var mover in Identity.Letters + "ST")
        {
            var moving = (await Commands.ReadAsync($"_BG{mover}", cancellation).ConfigureAwait(false)).ValuesOrEmpty;
            if (moving is 1.0) return Wording.Get(mover is 'S' or 'T' ? "ControllerSession.PlaneMoving" : "ControllerSession.AxisMoving", mover);
        }

        return null;
    }

    /// <summary>Uses the state that an earlier session found and could not restore as the state to restore.</summary>
    internal void AdoptFoundState(FoundState found) => Found = found;

    /// <summary>Reads the software limits before they are changed, so that they are restored with the other settings; only once.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    internal async Task NoteSoftLimitsAsync(IReadOnlyList<SoftLimit> limits, CancellationToken cancellation)
    {
        foreach (var operand in limits.SelectMany(limit => new[] { $"_FL{limit.Axis}", $"_BL{limit.Axis}" }))
        {
            if (HasFound(operand) || (await Commands.ReadWholeAsync(operand, cancellation).ConfigureAwait(false)).ValuesOrEmpty is not { } value) continue;
            Found = Found with { Motion = [.. Found.Motion, new FoundSetting(operand, $"{operand[1..]}={DmcFormat.Number(value)}")] };
        }
    }

    /// <summary>FL and BL: the controller brakes an axis that moves outwards one count beyond its travel (galil-dmc.md C), so that both ends can be reached.
    /// Limits that the controller did not report are not changed.</summary>
    internal IEnumerable<string> SoftLimitCommands(IReadOnlyList<SoftLimit> limits)
    {
        foreach (var limit in limits.Where(limit => HasFound($"_FL{limit.Axis}") && HasFound($"_BL{limit.Axis}")))
        {
            yield return string.Create(CultureInfo.InvariantCulture, $"FL{limit.Axis}={Math.Min(int.MaxValue, limit.Max + 1L)}");
            yield return string.Create(CultureInfo.InvariantCulture, $"BL{limit.Axis}={Math.Max(int.MinValue, limit.Min - 1L)}");
        }
    }

    private bool HasFound(string operand) => Found.Motion.Any(setting => setting.Operand == operand);

    /// <summary>True when the watchdog of this program runs and another host sends it heartbeats: halting it would leave a machine without
    /// supervision.</summary>
    private async Task<bool> IsOwnJobRunningAsync(CancellationToken cancellation) =>
        (await Commands.ReadAsync($"_XQ{ResidentProgram.WatchdogThread}", cancellation).ConfigureAwait(false)).ValuesOrEmpty is >= 0
        && (await Commands.ReadAsync(ResidentProgram.Variables.Heartbeat, cancellation).ConfigureAwait(false)).ValuesOrEmpty is > 0;

    /// <summary>Restores speeds, accelerations and motors. Call at rest.</summary>
    /// <returns>One sentence for each setting that could not be restored.</returns>
    /// <exception cref="ControllerException">The link failed meanwhile.</exception>
    public async Task<IReadOnlyList<string>> RestoreAsync(CancellationToken cancellation)
    {
        var commands = Found.Motion.Select(setting => setting.RestoreCommand).Concat(Found.MotorsOff.Select(letter => $"MO{letter}"));
        return await SendEachAsync(commands, cancellation).ConfigureAwait(false);
    }

    /// <summary>Another host or program has changed these settings: <see cref="RestoreAsync"/> keeps their present values.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    internal async Task AdoptPresentAsync(IReadOnlyList<string> operands) => Found = await Found.WithPresentAsync(Commands, operands, CancellationToken.None).ConfigureAwait(false);

    /// <summary>Burns the controller's parameters (BN), with CW and the number format as found: both are burned with the others (galil-dmc.md A.6).</summary>
    /// <exception cref="ControllerException">The link failed meanwhile.</exception>
    internal async Task<Rejected?> BurnAsync(CancellationToken cancellation)
    {
        await SendEachAsync(Found.Wire.RestoreCommands(null), cancellation).ConfigureAwait(false);
        var reply = await Commands.BurnAsync(CancellationToken.None).ConfigureAwait(false);
        await ConfigureLinkAsync(CancellationToken.None).ConfigureAwait(false);
        return reply as Rejected;
    }

    public async ValueTask DisposeAsync()
    {
        try
        {
            var echo = Found.Wire.Echo is null ? null : (await Commands.ReadAsync("_EO", CancellationToken.None).ConfigureAwait(false)).ValuesOrEmpty;
            await SendEachAsync(Found.Wire.RestoreCommands(echo), CancellationToken.None).ConfigureAwait(false);
        }
        catch (ControllerException)
        {
            // The link is lost: nothing can be sent.
        }

        if (_second is not null) await _second.DisposeAsync().ConfigureAwait(false);
        await _commands.DisposeAsync().ConfigureAwait(false);
    }

    private async Task<IReadOnlyList<string>> SendEachAsync(IEnumerable<string> commands, CancellationToken cancellation)
    {
        var failures = new List<string>();
        foreach (var command in commands)
        {
            if (await Commands.SendAsync(command, cancellation).ConfigureAwait(false) is Rejected rejected) failures.Add(rejected.Explain());
        }

        return failures;
    }

    /// <summary>Configures the link: no pushed records, unsolicited bytes marked with bit 7 and sent to the handle that does not run the job, numbers wide
    /// enough for any position; on a serial line without decimals, because every byte takes time.</summary>
    private async Task ConfigureLinkAsync(CancellationToken cancellation)
    {
        if (Found.Wire.RecordPeriod is not 0.0) await _commands.SendAsync("DR 0", cancellation).ConfigureAwait(false);
        await _commands.SendAsync("CW 1", cancellation).ConfigureAwait(false);
        await (_second ?? _commands).SendAsync("CF I", cancellation).ConfigureAwait(false);
        await _commands.SendAsync(Line is null ? "VF 10.4" : "VF 10.0", cancellation).ConfigureAwait(false);
        if (Line is not null) await _commands.CompareEchoAsync(cancellation).ConfigureAwait(false); // only now, because unsolicited text must be marked to be distinguished from a wrong echo
    }
}
