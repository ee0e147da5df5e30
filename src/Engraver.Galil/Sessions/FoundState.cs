using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>The controller as it was found: what this program changes, so that it can be left so (galil-dmc.md F.2, L.3). What the controller cannot say is not in it.</summary>
/// <param name="Wire">CF, CW, DR and the number format: changed by the handshake.</param>
/// <param name="Motion">VS VA VD VR of the S plane and SP AC DC of every axis: changed by a job.</param>
/// <param name="MotorsOff">Letters of the axes whose motor was off.</param>
public sealed record FoundState(WireState Wire, IReadOnlyList<FoundSetting> Motion, string MotorsOff)
{
    internal static async Task<FoundState> ReadAsync(CommandChannel channel, string letters, bool? echo, CancellationToken cancellation)
    {
        var wire = await WireState.ReadAsync(channel, echo, cancellation).ConfigureAwait(false);
        var motion = new List<FoundSetting>();
        foreach (var (operand, command) in Settings(letters))
        {
            var reading = await channel.ReadAsync(operand, cancellation).ConfigureAwait(false);
            if (reading.OrNothing is { } value) motion.Add(new FoundSetting(operand, command, value));
        }

        var off = "";
        foreach (var letter in letters)
        {
            var reading = await channel.ReadAsync("_MO" + letter, cancellation).ConfigureAwait(false);
            if (reading.OrNothing is 1.0) off += letter;
        }

        return new FoundState(wire, motion, off);
    }

    private static IEnumerable<(string Operand, string Command)> Settings(string letters)
    {
        foreach (var name in new[] { "VS", "VA", "VD" }) yield return ($"_{name}S", $"{name}S=");

        // VR has no form with a plane letter; the first field is the S plane (galil-dmc.md B.1).
        yield return ("_VRS", "VR ");
        foreach (var letter in letters)
        {
            foreach (var name in new[] { "SP", "AC", "DC" }) yield return ($"_{name}{letter}", $"{name}{letter}=");
        }
    }
}
