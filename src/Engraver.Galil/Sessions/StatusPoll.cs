using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Reads the state of an idle controller: two queries, of which a controller with fewer features may refuse the second.</summary>
internal static class StatusPoll
{
    /// <summary>Stop code of an axis that was switched off because of its position error (galil-dmc.md A.10).</summary>
    private const int PositionError = 8;

    /// <param name="axes">Those that a job moves.</param>
    /// <exception cref="ControllerException">The link failed, or the controller cannot say where it is.</exception>
    public static async ValueTask<MachineReading> ReadAsync(CommandChannel channel, MachineAxes axes, CancellationToken cancellation)
    {
        var letters = axes.Letters;
        var motion = await channel.ReadAsync($"{Each("_RP")},{Each("_TE")},_BGS,{Each("_BG")},{Each("_MO")}", cancellation).ConfigureAwait(false);
        if (motion.Refusal is { } refused) throw new ProtocolViolationException(refused.Explain());
        var v = motion.Values;
        var found = new MachineReading((int)v[0], (int)v[1], (int)v[2], (int)v[3], v[4] != 0 || v[5] != 0 || v[6] != 0, Those(letters, [v[7] != 0, v[8] != 0]));
        var inputs = await channel.ReadAsync($"_TI0,_OP0,_VMS,{string.Join(',', letters.Select(letter => $"_LF{letter},_LR{letter}"))},{Each("_SC")},_AB,_XQ0", cancellation).ConfigureAwait(false);
        return inputs.Refusal is null ? WithInputs(found, letters, inputs.Values) : found;

        string Each(string operand) => DmcAxes.Operands(letters, operand);
    }

    private static MachineReading WithInputs(MachineReading found, string letters, IReadOnlyList<double> v) => found with
    {
        Inputs = (int)v[0],
        Outputs = (int)v[1],
        Speed = v[2],
        Limit = string.Join(Wording.Get("Common.And"), LimitsHit(letters, v)),
        LostPosition = string.Concat(Those(letters, [v[7] == PositionError, v[8] == PositionError]).Intersect(found.MotorsOff)),
        AbortInput = v[9] == 0,
        ProgramRuns = v[10] >= 0,
    };

    private static string Those(string letters, bool[] chosen) => string.Concat(letters.Where((_, i) => chosen[i]));

    /// <summary>_LF and _LR are 0 where the switch is hit; they begin at the fourth answer.</summary>
    private static IEnumerable<string> LimitsHit(string letters, IReadOnlyList<double> v)
    {
        for (var i = 0; i < letters.Length; i++)
        {
            if (v[3 + (2 * i)] == 0) yield return Wording.Get("StatusPoll.ForwardLimit", letters[i]);
            if (v[4 + (2 * i)] == 0) yield return Wording.Get("StatusPoll.ReverseLimit", letters[i]);
        }
    }
}
