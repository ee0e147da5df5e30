using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Reads the state of an idle controller with two queries; a controller with fewer features may refuse the second.</summary>
internal static class StatusPoll
{
    /// <summary>Stop code of an axis that was switched off because of its position error (galil-dmc.md A.10).</summary>
    private const int PositionError = 8;

    /// <summary>Index of the first axis's _LF in the reply to the second query.</summary>
    private const int FirstLimit = 3;

    /// <param name="axes">The axes that a job moves.</param>
    /// <exception cref="ControllerException">The link failed, or the controller cannot report its position.</exception>
    public static async ValueTask<MachineReading> ReadAsync(CommandChannel channel, MachineAxes axes, CancellationToken cancellation)
    {
        var letters = axes.Letters;
        var motion = await channel.ReadAsync($"{Each("_RP")},{Each("_TE")},_BGS,{Each("_BG")},{Each("_MO")}", cancellation).ConfigureAwait(false);
        if (motion.Refusal is { } refused) throw new ProtocolViolationException(refused.Explain());
        var (n, v) = (letters.Length, motion.Values.ToArray());
        var found = new MachineReading(CountsPoint.From(v.AsSpan(0, n)), CountsPoint.From(v.AsSpan(n, n)), v.AsSpan(2 * n, n + 1).ContainsAnyExcept(0.0), LettersWhere(letters, v[((3 * n) + 1)..], value => value != 0));
        var inputs = await channel.ReadAsync($"_TI0,_OP0,_VMS,{string.Join(',', letters.Select(letter => $"_LF{letter},_LR{letter}"))},{Each("_SC")},_AB,_XQ0", cancellation).ConfigureAwait(false);
        return inputs.Refusal is null ? WithInputs(found, axes, [.. inputs.Values]) : found;

        string Each(string operand) => DmcAxes.Operands(letters, operand);
    }

    private static MachineReading WithInputs(MachineReading found, MachineAxes axes, double[] v)
    {
        var letters = axes.Letters;
        var codes = v[(FirstLimit + (2 * letters.Length))..];
        return found with
        {
            Inputs = (int)v[0],
            Outputs = (int)v[1],
            Speed = v[2],
            Limit = string.Join(", ", LimitsHit(axes, v)),
            LostPosition = string.Concat(LettersWhere(letters, codes, code => code == PositionError).Intersect(found.MotorsOff)),
            StoppedWithoutRamp = LettersWhere(letters, codes, code => StopCodes.IsWithoutRamp((int)code)),
            AbortInput = codes[letters.Length] == 0,
            IsProgramRunning = codes[letters.Length + 1] >= 0,
        };
    }

    /// <summary>The letters of the axes whose values fulfil a condition; their values come first.</summary>
    private static string LettersWhere(string letters, double[] values, Func<double, bool> isSo) => string.Concat(letters.Where((_, i) => isSo(values[i])));

    /// <summary>_LF and _LR are 0 when the switch is hit.</summary>
    private static IEnumerable<string> LimitsHit(MachineAxes axes, double[] v)
    {
        var names = axes.NamesOf(axes.Letters);
        for (var i = 0; i < names.Length; i++)
        {
            if (v[FirstLimit + (2 * i)] == 0) yield return Wording.Get("StatusPoll.ForwardLimit", names[i]);
            if (v[FirstLimit + 1 + (2 * i)] == 0) yield return Wording.Get("StatusPoll.ReverseLimit", names[i]);
        }
    }
}
