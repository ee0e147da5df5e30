using Engraver.Simulator.Motion;

namespace Engraver.Simulator.Language;

/// <summary>One operand being read: <c>_SCA</c> has the suffix A, <c>_XQ0</c> the suffix 0.</summary>
internal readonly record struct OperandRequest(Machine Machine, CommandContext Context, string Suffix)
{
    public Axis Axis => Suffix.Length == 1 && AxisSelection.IndexOf(Suffix[0]) is >= 0 and var index
        ? Machine.Motion.Axes[index]
        : throw new CommandRefusedException(Tc.BadOperand);

    /// <summary>S without a suffix (galil-dmc.md I.12).</summary>
    public VectorPlane Plane => Suffix switch
    {
        "" or "S" => Machine.Motion.Planes[0],
        "T" => Machine.Motion.Planes[1],
        _ => throw new CommandRefusedException(Tc.BadOperand),
    };

    public bool IsPlane => Suffix is "S" or "T";

    public int Number(int largest) =>
        Suffix.Length == 0 ? 0
        : Suffix.Length == 1 && char.IsAsciiDigit(Suffix[0]) && Suffix[0] - '0' <= largest ? Suffix[0] - '0'
        : throw new CommandRefusedException(Tc.BadOperand);
}
