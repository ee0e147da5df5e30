using Engraver.Galil.Links;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Workbench.Machines;

/// <summary>One look at an idle controller, in its counts. What it does not know is null.</summary>
/// <param name="X">_RPA.</param>
/// <param name="Y">_RPB.</param>
/// <param name="ErrorX">_TEA.</param>
/// <param name="ErrorY">_TEB.</param>
/// <param name="Moves">_BGS, _BGA or _BGB.</param>
/// <param name="MotorsOff">Letters of the axes whose motor is off (_MOA, _MOB).</param>
internal sealed record MachinePoll(int X, int Y, int ErrorX, int ErrorY, bool Moves, string MotorsOff)
{
    /// <summary>Stop code of an axis that was switched off because of its position error (galil-dmc.md A.10).</summary>
    private const int PositionError = 8;

    private const string MotionOperands = "_RPA,_RPB,_TEA,_TEB,_BGS,_BGA,_BGB,_MOA,_MOB";

    private const string InputOperands = "_TI0,_OP0,_VMS,_LFA,_LRA,_LFB,_LRB,_SCA,_SCB,_AB,_XQ0";

    public int? Inputs { get; init; }

    public int? Outputs { get; init; }

    /// <summary>_VMS, counts/s.</summary>
    public double? Speed { get; init; }

    /// <summary>The limits that are hit, in words; empty for none.</summary>
    public string Limit { get; init; } = "";

    /// <summary>Letters of the axes that were switched off because of their position error.</summary>
    public string LostPosition { get; init; } = "";

    /// <summary>_AB is 0: the abort input is active.</summary>
    public bool AbortInput { get; init; }

    /// <summary>Thread 0 executes a program; it is none of ours while the machine is only watched.</summary>
    public bool ProgramRuns { get; init; }

    /// <exception cref="ControllerException">The link failed, or the controller cannot say where it is.</exception>
    public static async ValueTask<MachinePoll> ReadAsync(CommandChannel channel, CancellationToken cancellation)
    {
        var motion = await channel.ReadAsync(MotionOperands, cancellation).ConfigureAwait(false);
        if (motion.Refusal is { } refused) throw new ProtocolViolationException(refused.Explain());
        var v = motion.Values;
        var poll = new MachinePoll((int)v[0], (int)v[1], (int)v[2], (int)v[3], v[4] != 0 || v[5] != 0 || v[6] != 0, (v[7] != 0 ? "A" : "") + (v[8] != 0 ? "B" : ""));
        var inputs = await channel.ReadAsync(InputOperands, cancellation).ConfigureAwait(false);
        return inputs.Refusal is null ? poll.WithInputs(inputs.Values) : poll;
    }

    /// <summary>True when a person or a program has changed something that arming relied on.</summary>
    public bool DiffersFrom(MachinePoll other) =>
        (X, Y, Moves, MotorsOff, Limit, AbortInput, ProgramRuns, Inputs) != (other.X, other.Y, other.Moves, other.MotorsOff, other.Limit, other.AbortInput, other.ProgramRuns, other.Inputs);

    private MachinePoll WithInputs(IReadOnlyList<double> v) => this with
    {
        Inputs = (int)v[0],
        Outputs = (int)v[1],
        Speed = v[2],
        Limit = LimitText(v[3], v[4], v[5], v[6]),
        LostPosition = (v[7] == PositionError && MotorsOff.Contains('A', StringComparison.Ordinal) ? "A" : "") + (v[8] == PositionError && MotorsOff.Contains('B', StringComparison.Ordinal) ? "B" : ""),
        AbortInput = v[9] == 0,
        ProgramRuns = v[10] >= 0,
    };

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
