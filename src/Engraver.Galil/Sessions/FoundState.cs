using Engraver.Galil.Language;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>The settings that this program changes, as found, so that they can be restored (galil-dmc.md F.2, L.3). Settings that the controller does not
/// report are missing.</summary>
/// <param name="Wire">CF, CW, DR and the number format: changed by the handshake.</param>
/// <param name="Motion">The selected plane, VS VA VD VR of the S plane and SP AC DC ER of every axis: changed by a job.</param>
/// <param name="MotorsOff">Letters of the axes whose motor was off.</param>
public sealed record FoundState(WireState Wire, IReadOnlyList<FoundSetting> Motion, string MotorsOff)
{
    internal static async Task<FoundState> ReadAsync(CommandChannel channel, string letters, bool? echo, CancellationToken cancellation)
    {
        var wire = await WireState.ReadAsync(channel, echo, cancellation).ConfigureAwait(false);
        var motion = new List<FoundSetting>();
        if ((await channel.ReadWholeAsync("_CA", cancellation).ConfigureAwait(false)).ValuesOrEmpty is { } plane) motion.Add(new FoundSetting("_CA", plane == 0.0 ? "CAS" : "CAT"));
        if (await SpeedRatioAsync(channel, cancellation).ConfigureAwait(false) is { } ratio) motion.Add(new FoundSetting("_VRS", ratio));
        foreach (var (operand, command) in WholeNumbers(letters))
        {
            var reading = await channel.ReadWholeAsync(operand, cancellation).ConfigureAwait(false);
            if (reading.ValuesOrEmpty is { } value) motion.Add(new FoundSetting(operand, command + DmcFormat.Number(value)));
        }

        var off = "";
        foreach (var letter in letters)
        {
            var reading = await channel.ReadWholeAsync("_MO" + letter, cancellation).ConfigureAwait(false);
            if (reading.ValuesOrEmpty is 1.0) off += letter;
        }

        return new FoundState(wire, motion, off);
    }

    /// <summary>The same state with the present values of some settings.</summary>
    /// <param name="operands">Operands of settings of the S plane or of an axis; those that are not among <see cref="Motion"/> remain missing.</param>
    internal async Task<FoundState> WithPresentAsync(CommandChannel channel, IReadOnlyList<string> operands, CancellationToken cancellation)
    {
        var motion = new List<FoundSetting>();
        foreach (var setting in Motion)
        {
            var present = operands.Contains(setting.Operand) ? await PresentAsync(channel, setting, cancellation).ConfigureAwait(false) : null;
            motion.Add(present is null ? setting : setting with { RestoreCommand = present });
        }

        return this with { Motion = motion };
    }

    private static async Task<string?> PresentAsync(CommandChannel channel, FoundSetting setting, CancellationToken cancellation)
    {
        if (setting.Operand == "_VRS") return await SpeedRatioAsync(channel, cancellation).ConfigureAwait(false);
        return (await channel.ReadWholeAsync(setting.Operand, cancellation).ConfigureAwait(false)).ValuesOrEmpty is { } value ? $"{setting.Operand[1..]}={DmcFormat.Number(value)}" : null;
    }

    /// <summary>VR as hexadecimal, which is exact: it has a resolution of 1/65536, and decimals are truncated to four (0.3 would be read as 0.2999;
    /// galil-dmc.md A.3 Numbers, E Messages).</summary>
    /// <remarks>VR has no form with a plane letter; the first field is the S plane (galil-dmc.md B.1).</remarks>
    private static async Task<string?> SpeedRatioAsync(CommandChannel channel, CancellationToken cancellation)
    {
        if (await channel.SendAsync("MG _VRS{$8.4}", cancellation).ConfigureAwait(false) is Accepted { Data: ['$', ..] exact }) return "VR " + exact;
        return (await channel.ReadAsync("_VRS", cancellation).ConfigureAwait(false)).ValuesOrEmpty is { } ratio ? "VR " + DmcFormat.Number(ratio) : null;
    }

    private static IEnumerable<(string Operand, string Command)> WholeNumbers(string letters)
    {
        foreach (var name in new[] { "VS", "VA", "VD" }) yield return ($"_{name}S", $"{name}S=");
        foreach (var letter in letters)
        {
            foreach (var name in new[] { "SP", "AC", "DC", "ER" }) yield return ($"_{name}{letter}", $"{name}{letter}=");
        }
    }
}

/// <summary>A setting as found at connect, with the command that restores it exactly.</summary>
/// <param name="Operand">The operand that was read, for example <c>_VAS</c>.</param>
/// <param name="RestoreCommand">For example <c>VAS=256000</c>.</param>
public sealed record FoundSetting(string Operand, string RestoreCommand);
