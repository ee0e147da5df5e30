using System.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.Benchmarks.Links;

/// <summary>A way in which a serial link ends.</summary>
/// <param name="Reads">Whether a read waits.</param>
/// <param name="Writes">Whether a write waits, because the other side reads nothing.</param>
internal sealed record LinkEnd(string Name, LinkEnding Ending, bool Reads = false, bool Writes = false)
{
    private const byte Xoff = 0x13;

    /// <summary>More than the buffers of a terminal hold.</summary>
    private const int TooMuch = 1 << 20;

    /// <summary>After this time the read or write waits.</summary>
    private static readonly TimeSpan s_settling = TimeSpan.FromMilliseconds(200);

    /// <summary>A link that has not reported or released its device after this time will not do so.</summary>
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(20);

    private static readonly TimeSpan s_retry = TimeSpan.FromMilliseconds(1);

    public SerialFlow Flow { get; init; } = SerialFlow.RtsCts;

    /// <summary>Opens a link, ends it, and measures.</summary>
    public async Task<LinkEndFigure> RunAsync(SerialDriver driver, Func<BenchTerminal, SerialDriver, SerialFlow, MachineConnection> connect, CancellationToken stop)
    {
        using var terminal = new BenchTerminal();
        await using var connection = connect(terminal, driver, Flow);
        var link = await connection.OpenLinkAsync(stop).ConfigureAwait(false);
        if (Flow == SerialFlow.XonXoff) terminal.Send([Xoff]);
        await Task.Delay(s_settling, stop).ConfigureAwait(false);
        var start = Stopwatch.GetTimestamp();
        var waiting = WaitAsync(link, stop);
        if (Ending != LinkEnding.None)
        {
            await Task.Delay(s_settling, stop).ConfigureAwait(false);
            start = Stopwatch.GetTimestamp();
        }

        if (Ending == LinkEnding.Vanish) terminal.Dispose();
        if (Ending != LinkEnding.Close) await Task.WhenAny(waiting, Task.Delay(s_patience, stop)).ConfigureAwait(false);
        var reported = Stopwatch.GetElapsedTime(start);
        var closing = Stopwatch.GetTimestamp();
        await link.DisposeAsync().ConfigureAwait(false);
        var closed = Stopwatch.GetElapsedTime(closing);
        if (Ending == LinkEnding.Close)
        {
            await Task.WhenAny(waiting, Task.Delay(s_patience, stop)).ConfigureAwait(false);
            reported = Stopwatch.GetElapsedTime(start);
        }

        return new LinkEndFigure(waiting.IsCompleted ? await waiting.ConfigureAwait(false) : "not reported", reported, closed, Ending == LinkEnding.Vanish ? null : await FreeAsync(connection, closing, stop).ConfigureAwait(false));
    }

    /// <summary>Reads or writes until the link fails.</summary>
    /// <returns>The message of the failure.</returns>
    private async Task<string> WaitAsync(IControllerLink link, CancellationToken stop)
    {
        await Task.Yield();
        try
        {
            if (Writes) await link.WriteAsync(new byte[TooMuch], stop).ConfigureAwait(false);
            if (Reads) await link.ReadAsync(new byte[1], stop).ConfigureAwait(false);
            return "not reported";
        }
        catch (IOException failure)
        {
            return failure.Message;
        }
    }

    /// <summary>Time until the device can be opened again; null if it stays locked.</summary>
    private static async Task<TimeSpan?> FreeAsync(MachineConnection connection, long since, CancellationToken stop)
    {
        while (Stopwatch.GetElapsedTime(since) < s_patience)
        {
            try
            {
                var again = await connection.OpenLinkAsync(stop).ConfigureAwait(false);
                var free = Stopwatch.GetElapsedTime(since);
                await again.DisposeAsync().ConfigureAwait(false);
                return free;
            }
            catch (ControllerLinkException)
            {
                await Task.Delay(s_retry, stop).ConfigureAwait(false);
            }
        }

        return null;
    }
}

/// <summary>What ends a link.</summary>
internal enum LinkEnding
{
    /// <summary>Its own time-out.</summary>
    None,

    /// <summary>The other side is closed.</summary>
    Vanish,

    /// <summary>The link is closed.</summary>
    Close,
}

/// <summary>How a link ended.</summary>
/// <param name="Report">Message of the failure.</param>
/// <param name="Reported">Time until it.</param>
/// <param name="Closed">Duration of closing the link.</param>
/// <param name="Free">Time from the start of closing until the device can be opened again; null if it cannot, or no longer exists.</param>
internal sealed record LinkEndFigure(string Report, TimeSpan Reported, TimeSpan Closed, TimeSpan? Free);
