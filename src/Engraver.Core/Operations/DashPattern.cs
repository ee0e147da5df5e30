using Engraver.Core.Drawings;

namespace Engraver.Core.Operations;

/// <summary>The pattern of a linetype in millimetres, and where its dashes are along a curve.</summary>
/// <remarks>Alignment type A of AutoCAD (Customization Guide, "Simple Custom Linetypes"): the pattern of an open curve begins and ends with at least half of
/// its first dash; these two are lengthened alike until whole patterns fit between them, and a curve that is shorter than one pattern is continuous. The guide
/// leaves closed curves open; on these, and in a pattern that begins with a dot, which cannot be lengthened, the pattern is stretched so that a whole number of
/// it fits.</remarks>
internal sealed class DashPattern
{
    /// <summary>Length of the mark of a dot, mm, unless half of the smallest gap is less.</summary>
    public const double DotLength = 0.1;

    /// <summary>Part of a pattern by which a length may fall short of a whole number of it by rounding.</summary>
    private const double Rounding = 1e-9;

    private readonly double[] _elements;

    private DashPattern(double[] elements) => _elements = elements;

    /// <summary>Length of the pattern.</summary>
    public double Period => _elements.Sum(Math.Abs);

    /// <summary>Length of its smallest gap.</summary>
    public double SmallestGap => -_elements.Where(element => element < 0.0).Max();

    /// <summary>Number of its dashes and dots.</summary>
    public int Dashes => _elements.Count(element => element >= 0.0);

    /// <summary>Null for a linetype without gaps or without dashes.</summary>
    /// <param name="scale">Millimetres for a unit of the linetype.</param>
    public static DashPattern? Of(Linetype linetype, double scale)
    {
        // A pattern of type A begins with a dash or dot; one that does not is read from its first dash on.
        var first = linetype.Elements.ToList().FindIndex(element => element >= 0.0);
        if (first < 0 || !linetype.Elements.Any(element => element < 0.0)) return null;
        double[] elements = [.. linetype.Elements.Skip(first).Concat(linetype.Elements.Take(first)).Select(element => element * scale)];
        return double.IsFinite(elements.Sum(Math.Abs)) && elements.Sum(Math.Abs) > 0.0 ? new DashPattern(elements) : null;
    }

    /// <summary>The dashes along a curve, as lengths from its start, in order.</summary>
    public IEnumerable<(double From, double To)> Along(double length, bool isClosed)
    {
        if (length < Period * (1.0 - Rounding)) return [(0.0, length)];
        return isClosed || _elements[0] == 0.0 ? Stretched(length, isClosed) : BetweenDashes(length);
    }

    private IEnumerable<(double From, double To)> BetweenDashes(double length)
    {
        var count = (long)Math.Floor((length / Period) + Rounding);
        var end = (length - (count * Period) + _elements[0]) / 2.0;
        var at = end;
        yield return (0.0, end);
        for (var pattern = 0L; pattern < count; pattern++)
        {
            for (var i = pattern == 0 ? 1 : 0; i < _elements.Length; i++)
            {
                if (_elements[i] >= 0.0) yield return Mark(at, _elements[i], length, 1.0);
                at += Math.Abs(_elements[i]);
            }
        }

        yield return (length - end, length);
    }

    private IEnumerable<(double From, double To)> Stretched(double length, bool isClosed)
    {
        var count = Math.Max(1L, (long)Math.Round(length / Period));
        var stretch = length / (count * Period);
        var at = 0.0;
        for (var pattern = 0L; pattern < count; pattern++)
        {
            foreach (var element in _elements)
            {
                if (element >= 0.0) yield return Mark(at, element * stretch, length, stretch);
                at += Math.Abs(element) * stretch;
            }
        }

        if (!isClosed) yield return Mark(length, 0.0, length, stretch);
    }

    /// <summary>A dash, or the mark of a dot, which is within the curve.</summary>
    private (double From, double To) Mark(double at, double dash, double length, double stretch)
    {
        if (dash > 0.0) return (at, at + dash);
        var mark = Math.Min(DotLength, SmallestGap * stretch / 2.0);
        var from = Math.Clamp(at - (mark / 2.0), 0.0, length - mark);
        return (from, from + mark);
    }
}
