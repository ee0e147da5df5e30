using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.GcodeReading;

/// <summary>The arc of G2 or G3 from its words (rs274-hpgl.md 1.3): by its centre, with nearly equal distances of both ends, or by its radius.</summary>
/// <param name="Centre">Centre, millimetres.</param>
/// <param name="From">Direction from the centre to the start, radians.</param>
/// <param name="Sweep">Sweep in radians, counter-clockwise positive.</param>
/// <param name="StartRadius">Radius at the start, millimetres.</param>
/// <param name="EndRadius">Radius at the last point before the end. LinuxCNC spirals to the distance of the end from the centre; grbl keeps the radius of the
/// start and then moves straight to the end.</param>
internal readonly record struct GcodeArc(Point2D Centre, double From, double Sweep, double StartRadius, double EndRadius)
{
    /// <summary>Allowed difference of the radii at the ends of a centre arc, millimetres; a larger difference is allowed if it is a small fraction of the
    /// radius.</summary>
    private const double RadiusDifference = 0.005;
    private const double LargestDifference = 0.5;
    private const double RadiusPart = 0.001;

    /// <summary>Amount by which a radius may be too short for its chord, millimetres.</summary>
    private const double ShortRadius = 0.00127;

    /// <summary>A smaller turn counts as a full turn, radians.</summary>
    private const double NoTurn = 5e-7;

    /// <summary>The place at a part of the sweep.</summary>
    public Point2D At(double part)
    {
        var (turn, radius) = (From + (Sweep * part), StartRadius + ((EndRadius - StartRadius) * part));
        return new Point2D(Centre.X + (radius * Math.Cos(turn)), Centre.Y + (radius * Math.Sin(turn)));
    }

    /// <returns>Null when the ends are not on one circle, with the reason.</returns>
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

    /// <returns>Null when no such arc joins the ends, with the reason.</returns>
    public static GcodeArc? ByRadius(Point2D start, Point2D end, double radius, bool clockwise, GcodeController controller, out string reason)
    {
        reason = "";
        var (x, y) = (end.X - start.X, end.Y - start.Y);
        var (chord, size) = (Math.Sqrt((x * x) + (y * y)), Math.Abs(radius));
        if (chord == 0.0) reason = Wording.Get("GcodeReader.RadiusNeedsChord");
        else if (size < (chord / 2.0) - ShortRadius) reason = Wording.Get("GcodeReader.RadiusTooSmall", size, chord);
        if (reason.Length > 0) return null;
        var height = Math.Sqrt(Math.Max(0.0, (size * size) - (chord * chord / 4.0)));
        var left = clockwise == radius < 0.0 ? height : -height; // the centre of a short turn is on the side to which it turns
        return ByCentre(start, end, new Point2D(((start.X + end.X) / 2.0) - (y / chord * left), ((start.Y + end.Y) / 2.0) + (x / chord * left)), clockwise, controller, out reason);
    }

    private static double Square(double value) => value * value;
}
