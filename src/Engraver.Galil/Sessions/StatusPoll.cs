using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Reads the state of an idle controller: two queries, of which a controller with fewer features may refuse the second.</summary>
internal static class StatusPoll
{
    /// <summary>Stop code of an axis that was switched off because of its position error (galil-dmc.md A.10).</summary>
    private const int PositionError = 8;

    private const string MotionOperands = "_RPA,_RPB,_TEA,_TEB,_BGS,_BGA,_BGB,_MOA,_MOB";

    private const string InputOperands = "_TI0,_OP0,_VMS,_LFA,_LRA,_LFB,_LRB,_SCA,_SCB,_AB,_XQ0";

    /// <exception cref="ControllerException">The link failed, or the controller cannot say where it is.</exception>
    public static async ValueTask<MachineReading> ReadAsync(CommandChannel channel, CancellationToken cancellation)
    {
        var motion = await channel.ReadAsync(MotionOperands, cancellation).ConfigureAwait(false);
        if (motion.Refusal is { } refused) throw new ProtocolViolationException(refused.Explain());
        var v = motion.Values;
        var found = new MachineReading((int)v[0], (int)v[1], (int)v[2], (int)v[3], v[4] != 0 || v[5] != 0 || v[6] != 0, Letters(v[7] != 0, v[8] != 0));
        var inputs = await channel.ReadAsync(InputOperands, cancellation).ConfigureAwait(false);
        return inputs.Refusal is null ? WithInputs(found, inputs.Values) : found;
    }

    private static MachineReading WithInputs(MachineReading found, IReadOnlyList<double> v) => found with
    {
        Inputs = (int)v[0],
        Outputs = (int)v[1],
        Speed = v[2],
        Limit = LimitText(v[3], v[4], v[5], v[6]),
        LostPosition = string.Concat(Letters(v[7] == PositionError, v[8] == PositionError).Intersect(found.MotorsOff)),
        AbortInput = v[9] == 0,
        ProgramRuns = v[10] >= 0,
    };

    private static string Letters(bool first, bool second) => (first ? DmcAxes.Plane[..1] : "") + (second ? DmcAxes.Plane[1..2] : "");

    /// <summary>_LF and _LR are 0 where the switch is hit.</summary>
    private static string LimitText(double forwardA, double reverseA, double forwardB, double reverseB)
    {
        var hit = new List<string>();
        if (forwardA == 0) hit.Add("the forward limit of axis A");
        if (reverseA == 0) hit.Add("the reverse limit of axis A");
        if (forwardB == 0) hit.Add("the forward limit of axis B");
        if (reverseB == 0) hit.Add("the reverse limit of axis B");
        return string.Join(" and ", hit);
    }
}
