using System.Globalization;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>The settings of the link itself, as found; null if the controller does not report them.</summary>
/// <param name="Echo">_EO. Never sent over Ethernet, so it is restored only if it has changed.</param>
/// <param name="MessagePort">_CF: letter of the port that receives the text of programs (galil-dmc.md A.5).</param>
/// <param name="MessageMark">_CW: 1 marks unsolicited bytes with bit 7, 2 does not.</param>
/// <param name="RecordPeriod">_DR0: samples between pushed records, 0 for none.</param>
/// <param name="RecordHandle">_DR1.</param>
/// <param name="NumberFormat">_VF: m.n with one decimal, which may have been truncated when it was printed (8.2 reads 8.1999).</param>
public sealed record WireState(double? Echo, char? MessagePort, double? MessageMark, double? RecordPeriod, double? RecordHandle, double? NumberFormat)
{
    /// <param name="heardEcho">Whether the echo was on when a serial line was greeted; null for other links: the controller is queried.</param>
    internal static async Task<WireState> ReadAsync(CommandChannel channel, bool? heardEcho, CancellationToken cancellation)
    {
        async Task<double?> Ask(string operand) => (await channel.ReadWholeAsync(operand, cancellation).ConfigureAwait(false)).ValuesOrEmpty;
        var echo = heardEcho is { } heard ? heard ? 1.0 : 0.0 : await Ask("_EO").ConfigureAwait(false);
        var port = await Ask("_CF").ConfigureAwait(false);
        var mark = await Ask("_CW").ConfigureAwait(false);
        var period = await Ask("_DR0").ConfigureAwait(false);
        var handle = await Ask("_DR1").ConfigureAwait(false);
        var format = (await channel.ReadAsync("_VF{F10.4}", cancellation).ConfigureAwait(false)).ValuesOrEmpty;
        return new WireState(echo, port is >= 'A' and <= 'Z' ? (char)port : null, mark, period, handle, format);
    }

    /// <summary>The command that restores the number format exactly; null if the controller did not report it.</summary>
    public string? NumberFormatCommand => NumberFormat is { } format ? string.Create(CultureInfo.InvariantCulture, $"VF {format:0.0}") : null;

    /// <summary>The commands that restore the link, in an order that keeps the replies readable to the last.</summary>
    internal IEnumerable<string> RestoreCommands(double? echoNow)
    {
        if (NumberFormatCommand is { } format) yield return format;
        if (RecordPeriod is > 0 && RecordHandle is { } handle) yield return $"DR {DmcFormat.Number(RecordPeriod.Value)},{DmcFormat.Number(handle)}";
        if (MessagePort is { } port) yield return $"CF {port}";
        if (MessageMark is 1 or 2) yield return "CW " + DmcFormat.Number(MessageMark.Value);
        if (Echo is { } echo && echoNow is { } now && now != echo) yield return "EO " + DmcFormat.Number(echo);
    }
}
