using System.Globalization;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Tool off and machine at rest, in the complete order of galil-dmc.md F.4: CB, STS, ST AB, HX of our threads, wait for every _BG, CSS.</summary>
/// <remarks>Two passes. <see cref="Begin"/> goes at once over the stop handle, while the feeder may still have a command on its way; when the feeder is silent,
/// <see cref="FinishAsync"/> says it again, so that a BGS that arrived in between starts nothing.</remarks>
/// <param name="ownThreads">Ours; first the one that commands motion.</param>
public sealed class OperatorStop(ControllerSession session, int toolOutput, IReadOnlyList<int> ownThreads)
{
    private const string Operands = "_BGS,_BGA,_BGB,_CSS,_RPA,_RPB,TIME";

    /// <summary>Polls at standstill after which an open sequence is ended by AB1: STS does not close one that ran dry (galil-dmc.md B.7).</summary>
    private const int PatiencePolls = 20;

    private Task _begun = Task.CompletedTask;

    /// <summary>Switches the tool off, stops the plane and the axes and halts the thread that commands motion, at once; the watchdog lives on until the machine stands. Returns without waiting; failures are told by <see cref="FinishAsync"/>.</summary>
    public void Begin() => _begun = HaltAsync(ownThreads.Take(1));

    /// <summary>Brakes again, halts our threads and waits until the machine stands, however long it brakes. Then the segment buffer is emptied.</summary>
    /// <returns>Where the machine stands, and _CSS before the buffer was emptied.</returns>
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
            // The handle for the stop is lost, the one for commands still stands.
            return await StopAsync(pollInterval, cancellation).ConfigureAwait(false);
        }
    }

    private async Task<StandstillReport> StopAsync(TimeSpan pollInterval, CancellationToken cancellation)
    {
        await HaltAsync(ownThreads).ConfigureAwait(false);
        var report = await WaitForRestAsync(pollInterval, cancellation).ConfigureAwait(false);
        await SendAsync("CSS").ConfigureAwait(false);
        return report;
    }

    private async Task HaltAsync(IEnumerable<int> threads)
    {
        await BrakeAsync().ConfigureAwait(false);
        foreach (var thread in threads) await SendAsync(string.Create(CultureInfo.InvariantCulture, $"HX{thread}")).ConfigureAwait(false);

        // A program of ours may have begun a motion or switched the tool between the stop and its halt.
        await BrakeAsync().ConfigureAwait(false);
    }

    private async Task BrakeAsync()
    {
        await SendAsync(string.Create(CultureInfo.InvariantCulture, $"CB {toolOutput}")).ConfigureAwait(false);
        await SendAsync("STS").ConfigureAwait(false);
        await SendAsync("ST AB").ConfigureAwait(false);
    }

    private async Task<StandstillReport> WaitForRestAsync(TimeSpan pollInterval, CancellationToken cancellation)
    {
        var last = new StandstillReport(0, 0, 0, 0);
        for (var standing = 0; ; standing++)
        {
            var reading = await session.StopHandle.ReadAsync(Operands, cancellation).ConfigureAwait(false);
            if (reading.Refusal is { } refused)
            {
                // Once is an accident; whoever never answers is asked no longer.
                if (standing > PatiencePolls) throw new ProtocolViolationException(refused.Explain());
                continue;
            }

            var v = reading.Values;
            var now = new StandstillReport((int)v[3], (int)v[4], (int)v[5], (long)v[6]);
            if (v[0] == 0 && v[1] == 0 && v[2] == 0) return now;
            if ((now.X, now.Y) != (last.X, last.Y)) standing = 0;
            if (standing == PatiencePolls) await SendAsync("AB 1").ConfigureAwait(false);
            last = now;
            if (pollInterval > TimeSpan.Zero) await Task.Delay(pollInterval, session.Time, cancellation).ConfigureAwait(false);
        }
    }

    /// <summary>A refusal does not keep the stop from going on: each command is worth trying on its own.</summary>
    private async Task SendAsync(string command) => await session.StopHandle.SendAsync(command, CancellationToken.None).ConfigureAwait(false);
}
