using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.Gcode;

/// <summary>The numbers that a program can say: whole multiples of its last decimal. Places are rounded to them, never ways, so that nothing adds up.</summary>
/// <param name="decimals">Digits behind the point.</param>
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

    /// <summary>As short as it can be said, exactly.</summary>
    public string Text(long units) => (units / (decimal)_perMillimetre).ToString(_form, CultureInfo.InvariantCulture);
}

/// <summary>A place in units of the grid.</summary>
internal readonly record struct GridPlace(long X, long Y);
