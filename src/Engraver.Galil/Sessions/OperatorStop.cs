using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Tool off and machine at rest, in the complete order of galil-dmc.md F.4: CB, STS, ST AB, HX of our threads, wait for every _BG, CSS.</summary>
/// <remarks>Two passes. <see cref="Begin"/> goes at once over the stop handle, while the feeder may still have a command on its way; when the feeder is silent,
/// <see cref="FinishAsync"/> says it again, so that a BGS that arrived in between starts nothing.</remarks>
/// <param name="ownThreads">Ours; first the one that commands motion.</param>
/// <param name="axes">Letters of the axes that brake and are waited for; of a job its X and then its Y.</param>
public sealed class OperatorStop(ControllerSession session, int toolOutput, IReadOnlyList<int> ownThreads, string axes)
{
    /// <summary>What rest is known by: the sequence and every axis, _CSS, where each axis stands, TIME.</summary>
    private readonly string _operands = $"_BGS,{DmcAxes.Operands(axes, "_BG")},_CSS,{DmcAxes.Operands(axes, "_RP")},TIME";

    /// <summary>Polls at standstill after which an open sequence is ended by AB1, because STS does not close one that ran dry (galil-dmc.md B.7).</summary>
    private const int PatiencePolls = 20;

    private Task _begun = Task.CompletedTask;

    /// <summary>Polls in which an axis is reported as moving and does not change its position; after these and AB1 it counts as at rest (VR 0, a jog at speed 0).</summary>
    private const int MostStandingPolls = 100;

    /// <summary>Switches the tool off, stops the plane and the axes and halts the thread that commands motion, at once; the watchdog runs on until the machine is at rest. Returns without waiting; <see cref="FinishAsync"/> reports failures.</summary>
    public void Begin() => _begun = BeginAsync();

    /// <summary>Runs the stop once at rest, before anything moves, so that its code is loaded and compiled: on a busy computer that would otherwise take time at the worst moment.</summary>
    /// <exception cref="ControllerException">The stop handle failed.</exception>
    public Task RehearseAsync() => BeginAsync();

    /// <summary>Stops motion that belongs to no job: the same commands, without waiting for rest. Returns when the controller has accepted them.</summary>
    /// <exception cref="ControllerException">The stop handle failed.</exception>
    public Task BrakeAtOnceAsync() => BeginAsync();

    /// <summary>All commands in one line: a further line could be delayed by a busy computer.</summary>
    private async Task BeginAsync()
    {
        var halt = ownThreads.Take(1).Select(thread => string.Create(CultureInfo.InvariantCulture, $"HX{thread}"));
        await SendAsync(string.Join(';', [.. BrakeCommands, .. halt])).ConfigureAwait(false);

        // Our program may have begun a motion or switched the tool between the stop and its halt.
        await BrakeAsync().ConfigureAwait(false);
    }

    /// <summary>Brakes again, halts our threads and waits until the machine is at rest, however long it brakes. Then empties the segment buffer.</summary>
    /// <returns>The position at rest, and _CSS before the buffer was emptied.</returns>
    /// <exception cref="ControllerException">Both handles failed.</exception>
    public async Task<StandstillReport> FinishAsync(TimeSpan pollInterval, CancellationToken cancellation)
    {
        try
        {
            await _begun.ConfigureAwait(false);
            return await StopAsync(pollInterval, cancellation).ConfigureAwait(false);
        }
        catch (ControllerException) when (!session.StopHandle.IsBroken)
        {
            // The stop handle is lost, the one for commands still works.
            return await StopAsync(pollInterval, cancellation).ConfigureAwait(false);
        }
    }

    private async Task<StandstillReport> StopAsync(TimeSpan pollInterval, CancellationToken cancellation)
    {
        await HaltAsync().ConfigureAwait(false);
        var report = await WaitForRestAsync(pollInterval, cancellation).ConfigureAwait(false);
        await SendAsync("CSS").ConfigureAwait(false);
        return report;
    }

    private string[] BrakeCommands => [string.Create(CultureInfo.InvariantCulture, $"CB {toolOutput}"), "STS", "ST " + axes];

    private async Task HaltAsync()
    {
        await BrakeAsync().ConfigureAwait(false);
        foreach (var thread in ownThreads)
        {
            var halt = string.Create(CultureInfo.InvariantCulture, $"HX{thread}");
            if (await SendAsync(halt).ConfigureAwait(false) is Rejected) await SendAsync(halt).ConfigureAwait(false); // a thread that runs on would begin the next motion
        }

        await BrakeAsync().ConfigureAwait(false);
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
            var v = await LookAsync(cancellation).ConfigureAwait(false);
            var (running, places) = (v[..(axes.Length + 1)], v[(axes.Length + 2)..^1]);
            if (!places.SequenceEqual(last)) standing = 0;
            if (running.All(runs => runs == 0) || standing == MostStandingPolls) return new StandstillReport((int)v[axes.Length + 1], (int)places[0], (int)places.ElementAtOrDefault(1), (long)v[^1]);
            if (standing == PatiencePolls) await SendAsync("AB 1").ConfigureAwait(false);
            last = places;
            if (pollInterval > TimeSpan.Zero) await Task.Delay(pollInterval, session.Time, cancellation).ConfigureAwait(false);
        }
    }

    /// <summary>Asks all at once and, where that is refused or longer than a line, one by one: what the controller does not know is not fitted and does not move. The position it must know.</summary>
    private async ValueTask<double[]> LookAsync(CancellationToken cancellation)
    {
        if (_operands.Length <= DmcLimits.LineLength - "MG ".Length && await session.StopHandle.ReadAsync(_operands, cancellation).ConfigureAwait(false) is { Refusal: null } all) return [.. all.Values];
        var values = new List<double>();
        foreach (var operand in _operands.Split(','))
        {
            var one = await session.StopHandle.ReadAsync(operand, cancellation).ConfigureAwait(false);
            if (one.Refusal is { } refused && operand.StartsWith("_RP", StringComparison.Ordinal)) throw new ProtocolViolationException(Wording.Get("OperatorStop.ToolOffMachineTold", refused.Explain()));
            values.Add(one.OrNothing ?? 0.0);
        }

        return [.. values];
    }

    /// <summary>Sends one command of the stop; its refusal does not prevent the others.</summary>
    private ValueTask<Reply> SendAsync(string command) => session.StopHandle.SendAsync(command, CancellationToken.None);
}

/// <summary>Where and when the machine came to rest.</summary>
/// <param name="SegmentCounter">_CSS before the buffer was emptied: segments of the stopped sequence that were done.</param>
/// <param name="X">_RP of the first axis, controller's counts.</param>
/// <param name="Y">Of the second.</param>
/// <param name="Time">TIME, samples.</param>
public sealed record StandstillReport(int SegmentCounter, int X, int Y, long Time);
