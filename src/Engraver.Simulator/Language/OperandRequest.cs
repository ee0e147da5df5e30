using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>One operand being read: <c>_SCA</c> has the suffix A, <c>_XQ0</c> the suffix 0.</summary>
/// <param name="Suffix">Characters after the two letters; a suffix of more than two is unknown.</param>
internal readonly record struct OperandRequest(Machine Machine, CommandContext Context, OperandSuffix Suffix)
{
    public Axis Axis => Suffix.Length == 1 && AxisSelection.IndexOf(Suffix.First) is >= 0 and var index
        ? Machine.Motion.Axes[index]
        : throw new CommandRefusedException(Tc.BadOperand);

    /// <summary>The plane of the suffix; S without one (galil-dmc.md I.12).</summary>
    public VectorPlane Plane => Suffix switch
    {
        { Length: 0 } or { Length: 1, First: 'S' } => Machine.Motion.Planes[0],
        { Length: 1, First: 'T' } => Machine.Motion.Planes[1],
        _ => throw new CommandRefusedException(Tc.BadOperand),
    };

    public bool IsPlane => Suffix is { Length: 1, First: 'S' or 'T' };

    public int Number(int largest) =>
        Suffix.Length == 0 ? 0
        : Suffix.Length == 1 && char.IsAsciiDigit(Suffix.First) && Suffix.First - '0' <= largest ? Suffix.First - '0'
        : throw new CommandRefusedException(Tc.BadOperand);
}
