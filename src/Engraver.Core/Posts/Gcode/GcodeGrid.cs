using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.Gcode;

/// <summary>The numbers that a program can contain: whole multiples of its last decimal. Positions are rounded to them, never distances, so that errors do not
/// accumulate.</summary>
/// <param name="decimals">Digits after the point.</param>
internal sealed class GcodeGrid(int decimals)
{
    /// <summary>Millimetres; with six decimals such a number has eleven digits, which a double holds.</summary>
    public const double Largest = 99_999.0;

    private readonly double _perMillimetre = Math.Pow(10.0, decimals);
    private readonly string _form = "0." + new string('#', decimals);

    /// <summary>One unit, millimetres.</summary>
    public double Unit => 1.0 / _perMillimetre;

    public long Of(double millimetres) => (long)Math.Round(millimetres * _perMillimetre);

    public GridPlace Of(Point2D place) => new(Of(place.X), Of(place.Y));

    public Point2D Millimetres(GridPlace place) => new(place.X / _perMillimetre, place.Y / _perMillimetre);

    /// <summary>The shortest exact text of the number.</summary>
    public string Text(long units) => (units / (decimal)_perMillimetre).ToString(_form, CultureInfo.InvariantCulture);
}

/// <summary>A place in units of the grid.</summary>
internal readonly record struct GridPlace(long X, long Y);
