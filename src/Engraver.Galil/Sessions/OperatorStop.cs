using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Switches the tool off and stops the machine, in the complete order of galil-dmc.md F.4: CB, STS, ST AB, HX of the own threads, wait for every _BG,
/// CSS.</summary>
/// <remarks>Two passes. <see cref="Start"/> sends the commands at once over the stop handle, while a command of the feeder may still be on its way. When the
/// feeder has ended, <see cref="FinishAsync"/> sends them again, so that a BGS that arrived in between starts nothing.</remarks>
/// <param name="outputs">Outputs that are switched off first (<see cref="MachineProfile.OffAtStop"/>).</param>
/// <param name="ownThreads">Threads of this program; first the one that commands motion.</param>
/// <param name="axes">Letters of the axes that are braked and waited for; for a job in the order of its axes.</param>
public sealed class OperatorStop(ControllerSession session, IReadOnlyList<OutputSwitch> outputs, IReadOnlyList<int> ownThreads, string axes)
{
    /// <summary>The operands that show rest: the sequence and every axis, _CSS, the position of each axis, TIME.</summary>
    private readonly string _operands = $"_BGS,{DmcAxes.Operands(axes, "_BG")},_CSS,{DmcAxes.Operands(axes, "_RP")},TIME";

    /// <summary>Polls at standstill after which an open sequence is ended by AB1, because STS does not close one that ran dry (galil-dmc.md B.7).</summary>
    private const int TimeoutPolls = 20;

    private Task _started = Task.CompletedTask;

    /// <summary>Polls in which an axis is reported as moving without a change of its position; after these and AB1 it counts as at rest (VR 0, a jog at speed
    /// 0).</summary>
    private const int MaxStandstillPolls = 100;

    /// <summary>Switches the tool off, stops the plane and the axes and halts the thread that commands motion, at once; the watchdog runs until the machine is
    /// at rest. Returns without waiting; <see cref="FinishAsync"/> reports failures.</summary>
    public void Start() => _started = StartAsync();

    /// <summary>Runs the stop once at rest, before anything moves, so that its code is loaded and compiled: on a busy computer that could otherwise delay an
    /// actual stop.</summary>
    /// <returns>False when an output that it switches off was on in between: a command was damaged during transmission.</returns>
    /// <exception cref="ControllerException">The stop handle failed.</exception>
    public async Task<bool> RehearseAsync()
    {
        await SendLineAsync().ConfigureAwait(false);
        var wasOn = await IsAnyOnAsync().ConfigureAwait(false);
        await BrakeAsync().ConfigureAwait(false);
        return !(await IsAnyOnAsync().ConfigureAwait(false) || wasOn);
    }

    /// <summary>Stops motion that does not belong to a job: the same commands, without waiting for rest. Returns when the controller has accepted
    /// them.</summary>
    /// <exception cref="ControllerException">The stop handle failed.</exception>
    public Task BrakeAtOnceAsync() => StartAsync();

    private async Task StartAsync()
    {
        await SendLineAsync().ConfigureAwait(false);

        // The program may have started a motion or switched the tool between the stop and its halt.
        await BrakeAsync().ConfigureAwait(false);
    }

    /// <summary>All commands in one line, because a busy computer could delay a further line.</summary>
    private async Task SendLineAsync()
    {
        var halt = ownThreads.Take(1).Select(thread => string.Create(CultureInfo.InvariantCulture, $"HX{thread}"));
        var line = string.Join(';', [.. BrakeCommands, .. halt]);
        await session.StopHandle.SendUrgentAsync(line).ConfigureAwait(false); // a late or lost reply delays nothing
        await SendAsync(line).ConfigureAwait(false);
    }

    /// <summary>Brakes again, halts the own threads and waits until the machine is at rest, without a limit for braking. Then empties the segment
    /// buffer.</summary>
    /// <returns>The position at rest, and _CSS before the buffer was emptied.</returns>
    /// <exception cref="ControllerException">Both handles failed.</exception>
    public async Task<StandstillReport> FinishAsync(TimeSpan pollInterval, CancellationToken cancellation)
    {
        try
        {
            await _started.ConfigureAwait(false);
            return await StopAsync(pollInterval, cancellation).ConfigureAwait(false);
        }
        catch (ControllerException) when (!session.StopHandle.IsBroken)
        {
            // The stop handle is lost, the command handle still works.
            return await StopAsync(pollInterval, cancellation).ConfigureAwait(false);
        }
    }

    private async Task<StandstillReport> StopAsync(TimeSpan pollInterval, CancellationToken cancellation)
    {
        var wasOn = await HaltAsync().ConfigureAwait(false);
        var report = await WaitForRestAsync(pollInterval, cancellation).ConfigureAwait(false);
        await SendAsync("CSS").ConfigureAwait(false);
        if (!await IsAnyOnAsync().ConfigureAwait(false)) return report with { WasToolOn = wasOn };
        await BrakeAsync().ConfigureAwait(false);
        return report with { WasToolOn = true, IsToolOn = await IsAnyOnAsync().ConfigureAwait(false) };
    }

    private string[] BrakeCommands => [.. outputs.Select(SwitchOffCommand), "STS", "ST " + axes];

    /// <summary>The command that switches off: CB, or SB where off is the active level of the output.</summary>
    internal static string SwitchOffCommand(OutputSwitch output) => string.Create(CultureInfo.InvariantCulture, $"{(output.IsActiveLow ? "SB" : "CB")} {output.Output}");

    /// <summary>True when an output that the stop switches off is on nevertheless: a command was damaged during transmission, or another host switches it.
    /// False if the controller does not report its outputs.</summary>
    private async ValueTask<bool> IsAnyOnAsync()
    {
        if (outputs.Count == 0) return false;
        return (await session.StopHandle.ReadAsync("_OP0", CancellationToken.None).ConfigureAwait(false)).ValuesOrEmpty is { } bits && outputs.Any(output => output.IsOn((int)bits));
    }

    /// <returns>True when an output that was to be off was on in between.</returns>
    private async Task<bool> HaltAsync()
    {
        await BrakeAsync().ConfigureAwait(false);
        foreach (var thread in ownThreads)
        {
            var halt = string.Create(CultureInfo.InvariantCulture, $"HX{thread}");
            if (await SendAsync(halt).ConfigureAwait(false) is Rejected) await SendAsync(halt).ConfigureAwait(false); // a running thread would start the next motion
        }

        var wasOn = await IsAnyOnAsync().ConfigureAwait(false);
        await BrakeAsync().ConfigureAwait(false);
        return wasOn;
    }

    private async Task BrakeAsync()
    {
        foreach (var command in BrakeCommands) await SendAsync(command).ConfigureAwait(false);
    }

    private async Task<StandstillReport> WaitForRestAsync(TimeSpan pollInterval, CancellationToken cancellation)
    {
        double[] last = [];
        for (var standing = 0; ; standing++)
        {
            var v = await ReadMotionAsync(cancellation).ConfigureAwait(false);
            var (running, places) = (v[..(axes.Length + 1)], v[(axes.Length + 2)..^1]);
            if (!places.SequenceEqual(last)) standing = 0;
            if (running.All(runs => runs == 0) || standing == MaxStandstillPolls) return new StandstillReport((int)v[axes.Length + 1], CountsPoint.From(places), (long)v[^1]);
            if (standing == TimeoutPolls) await SendAsync("AB 1").ConfigureAwait(false);
            last = places;
            if (pollInterval > TimeSpan.Zero) await Task.Delay(pollInterval, session.Time, cancellation).ConfigureAwait(false);
        }
    }

    /// <summary>Queries all operands at once and, if that is refused or longer than a line, one by one: an unsupported operand belongs to an axis that is not
    /// fitted and does not move. The position is required.</summary>
    private async ValueTask<double[]> ReadMotionAsync(CancellationToken cancellation)
    {
        if (_operands.Length <= DmcLimits.LineLength - "MG ".Length && await session.StopHandle.ReadAsync(_operands, cancellation).ConfigureAwait(false) is { Refusal: null } all) return [.. all.Values];
        var values = new List<double>();
        foreach (var operand in _operands.Split(','))
        {
            var one = await session.StopHandle.ReadAsync(operand, cancellation).ConfigureAwait(false);
            if (one.Refusal is { } refused && operand.StartsWith("_RP", StringComparison.Ordinal)) throw new ProtocolViolationException(Wording.Get("OperatorStop.PositionUnknown", refused.Explain()));
            values.Add(one.ValuesOrEmpty ?? 0.0);
        }

        return [.. values];
    }

    /// <summary>Sends one command of the stop; a refusal does not prevent the other commands.</summary>
    private ValueTask<Reply> SendAsync(string command) => session.StopHandle.SendAsync(command, CancellationToken.None);
}
