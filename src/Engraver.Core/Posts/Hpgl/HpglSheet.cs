using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.Hpgl;

/// <summary>The units of a program.</summary>
/// <param name="unitsPerMillimetre">40 for plotter units.</param>
internal sealed class HpglSheet(int unitsPerMillimetre)
{
    /// <summary>Plotter units are 0.025 mm.</summary>
    public const int PlotterUnits = 40;

    /// <summary>A number of HP-GL/2 has 23 bits and a sign.</summary>
    private const double LargestNumber = 8_388_607.0;

    public int PerMillimetre { get; } = unitsPerMillimetre;

    /// <summary>One unit, millimetres.</summary>
    public double Unit => 1.0 / PerMillimetre;

    /// <summary>The farthest place from the origin along an axis, millimetres.</summary>
    public double Largest => LargestNumber / Math.Max(PerMillimetre, PlotterUnits);

    public UnitPlace Of(Point2D place) => new((int)Math.Round(place.X * PerMillimetre), (int)Math.Round(place.Y * PerMillimetre));

    public Point2D Millimetres(UnitPlace place) => new((double)place.X / PerMillimetre, (double)place.Y / PerMillimetre);
}

/// <summary>A place in whole units.</summary>
internal readonly record struct UnitPlace(int X, int Y);
