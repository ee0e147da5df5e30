using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.GcodeReading;

/// <summary>The arc of G2 or G3 from its words (rs274-hpgl.md 1.3): by its centre, both ends about as far from it, or by its radius.</summary>
/// <param name="Centre">Millimetres.</param>
/// <param name="From">Direction from the centre to the start, radians.</param>
/// <param name="Sweep">Radians, counter-clockwise positive.</param>
/// <param name="StartRadius">Millimetres.</param>
/// <param name="EndRadius">Of the last place before the end. LinuxCNC spirals to the end's own distance from the centre; grbl keeps the radius of the start, and from there goes straight to the end.</param>
internal readonly record struct GcodeArc(Point2D Centre, double From, double Sweep, double StartRadius, double EndRadius)
{
    /// <summary>Ends of a centre arc may differ by so much from their radius, millimetres, or by so much more if it is a small part of it.</summary>
    private const double RadiusDifference = 0.005;
    private const double LargestDifference = 0.5;
    private const double RadiusPart = 0.001;

    /// <summary>A radius may be too short for its chord by so much, millimetres.</summary>
    private const double ShortRadius = 0.00127;

    /// <summary>A turn of less is a whole one, radians.</summary>
    private const double NoTurn = 5e-7;

    /// <summary>The place at a part of the sweep.</summary>
    public Point2D At(double part)
    {
        var (turn, radius) = (From + (Sweep * part), StartRadius + ((EndRadius - StartRadius) * part));
        return new Point2D(Centre.X + (radius * Math.Cos(turn)), Centre.Y + (radius * Math.Sin(turn)));
    }

    /// <returns>Null when the ends do not lie on one circle, and why.</returns>
    public static GcodeArc? ByCentre(Point2D start, Point2D end, Point2D centre, bool clockwise, GcodeController controller, out string reason)
    {
        reason = "";
        var isGrbl = controller == GcodeController.Grbl;
        var (first, last) = (Math.Sqrt(Square(start.X - centre.X) + Square(start.Y - centre.Y)), Math.Sqrt(Square(end.X - centre.X) + Square(end.Y - centre.Y)));
        var apart = Math.Abs(first - last);
        if (first == 0.0 || last == 0.0) reason = Wording.Get("GcodeReader.NoRadius");
        else if (apart > LargestDifference || (apart > RadiusDifference && apart > RadiusPart * (isGrbl ? first : Math.Max(first, last)))) reason = Wording.Get("GcodeReader.RadiiDiffer", apart);
        if (reason.Length > 0) return null;
        var (from, to) = (Math.Atan2(start.Y - centre.Y, start.X - centre.X), Math.Atan2(end.Y - centre.Y, end.X - centre.X));
        var sweep = clockwise ? from - to : to - from;
        while (sweep < NoTurn) sweep += 2.0 * Math.PI;
        while (sweep >= (2.0 * Math.PI) + NoTurn) sweep -= 2.0 * Math.PI;
        return new GcodeArc(centre, from, clockwise ? -sweep : sweep, first, isGrbl ? first : last);
    }

    /// <returns>Null when no such arc joins the ends, and why.</returns>
    public static GcodeArc? ByRadius(Point2D start, Point2D end, double radius, bool clockwise, GcodeController controller, out string reason)
    {
        reason = "";
        var (x, y) = (end.X - start.X, end.Y - start.Y);
        var (chord, size) = (Math.Sqrt((x * x) + (y * y)), Math.Abs(radius));
        if (chord == 0.0) reason = Wording.Get("GcodeReader.RadiusNeedsChord");
        else if (size < (chord / 2.0) - ShortRadius) reason = Wording.Get("GcodeReader.RadiusTooSmall", size, chord);
        if (reason.Length > 0) return null;
        var height = Math.Sqrt(Math.Max(0.0, (size * size) - (chord * chord / 4.0)));
        var left = clockwise == radius < 0.0 ? height : -height; // the centre of a short turn lies on the side to which it turns
        return ByCentre(start, end, new Point2D(((start.X + end.X) / 2.0) - (y / chord * left), ((start.Y + end.Y) / 2.0) + (x / chord * left)), clockwise, controller, out reason);
    }

    private static double Square(double value) => value * value;
}
