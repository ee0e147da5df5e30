using Engraver.Simulator.Values;

namespace Engraver.Simulator.Motion;

/// <summary>The axes and planes a command names, in the order named.</summary>
internal sealed class AxisSelection(MotionKernel motion)
{
    private const string Alternatives = "XYZW";

    public List<Axis> Axes { get; } = new(4);

    public List<VectorPlane> Planes { get; } = new(2);

    public bool IsEmpty => Axes.Count == 0 && Planes.Count == 0;

    /// <summary>The named axes, or axes A to D when no axis was named.</summary>
    public IEnumerable<Axis> AxesOrAll => IsEmpty ? motion.Axes.Take(Axis.Real) : Axes;

    /// <summary>0 to 5 for A to D, N, M and the alternative letters X to W; -1 for anything else (A.3).</summary>
    public static int IndexOf(char letter)
    {
        var index = Axis.Letters.IndexOf(letter, StringComparison.Ordinal);
        return index >= 0 ? index : Alternatives.IndexOf(letter, StringComparison.Ordinal);
    }

    /// <summary>True for E= to H=: an axis that only larger models have (TC 90).</summary>
    public static bool IsAbsent(ReadOnlySpan<char> text) => text is [>= 'E' and <= 'H', '=', ..];

    public void Add(char letter)
    {
        if (letter == '*')
        {
            Axes.AddRange(motion.Axes.Take(Axis.Real));
        }
        else if (letter is 'S' or 'T')
        {
            Planes.Add(motion.Planes[letter - 'S']);
        }
        else if (IndexOf(letter) is >= 0 and var index)
        {
            Axes.Add(motion.Axes[index]);
        }
        else
        {
            throw new CommandRefusedException(letter is >= 'E' and <= 'H' ? Tc.BadAxis : Tc.OperandError);
        }
    }
}
