using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>The variable axes ~a to ~h: 0 to 7 axes, 8 and 9 the planes, 10 and 11 the virtual axes (galil-dmc.md E).</summary>
internal sealed class VariableAxes
{
    private const string Letters = "ABCDEFGHSTNM";
    private readonly int[] _axes = new int[8];

    /// <param name="name">a to h.</param>
    /// <exception cref="CommandRefusedException">TC 4 for another name, TC 6 for a number that is not an axis.</exception>
    public int this[char name]
    {
        get => _axes[PlaceOf(name)];
        set => _axes[PlaceOf(name)] = value >= 0 && value < Letters.Length ? value : throw new CommandRefusedException(Tc.OutOfRange);
    }

    public char LetterOf(char name) => Letters[this[name]];

    private static int PlaceOf(char name) => name is >= 'a' and <= 'h' ? name - 'a' : throw new CommandRefusedException(Tc.OperandError);
}
