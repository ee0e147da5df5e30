using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>Adds an elliptical arc given by its ends, as in SVG (SVG 1.1, appendix F.6): radii that are too small are enlarged until the arc fits.</summary>
internal static class EllipticalArc
{
    public static void ArcTo(this VectorPath path, Point end, Size radii, double rotationDegrees, bool isLarge, bool isClockwise)
    {
        var start = path.Current;
        double rx = Math.Abs(radii.Width), ry = Math.Abs(radii.Height);
        if (start == end)
            return;
        if (rx < 1e-9 || ry < 1e-9)
        {
            path.LineTo(end);
            return;
        }
        var rotation = Matrix.CreateRotation(rotationDegrees * Math.PI / 180);
        var half = TurnedBack((start - end) * 0.5, rotation);
        var stretch = Math.Sqrt(Squared(half.X / rx) + Squared(half.Y / ry));
        if (stretch > 1)
            (rx, ry) = (rx * stretch, ry * stretch);
        var toEllipse = Matrix.CreateScale(rx, ry) * rotation;
        AddUnitArc(path, toEllipse, new Vector(half.X / rx, half.Y / ry), Middle(start, end), end, isLarge, isClockwise);
    }

    /// <summary>Works on the unit circle: <paramref name="half"/> is half the chord from end to start there.</summary>
    private static void AddUnitArc(VectorPath path, Matrix toEllipse, Vector half, Point middle, Point end, bool isLarge, bool isClockwise)
    {
        var chord = half.SquaredLength;
        var reach = chord <= 0 ? 0 : Math.Sqrt(Math.Max(0, 1 / chord - 1));
        var side = isLarge == isClockwise ? -1 : 1;
        var centre = new Vector(half.Y, -half.X) * (reach * side);
        var from = Math.Atan2(half.Y - centre.Y, half.X - centre.X);
        var sweep = Math.Atan2(-half.Y - centre.Y, -half.X - centre.X) - from;
        if (isClockwise && sweep < 0)
            sweep += 2 * Math.PI;
        if (!isClockwise && sweep > 0)
            sweep -= 2 * Math.PI;
        var place = Matrix.CreateTranslation(centre.X, centre.Y) * toEllipse * Matrix.CreateTranslation(middle.X, middle.Y);
        AddPieces(path, place, from, sweep, end);
    }

    private static void AddPieces(VectorPath path, Matrix place, double from, double sweep, Point end)
    {
        var count = Math.Max(1, (int)Math.Ceiling(Math.Abs(sweep) / (Math.PI / 2) - 1e-9));
        var step = sweep / count;
        var handle = 4.0 / 3 * Math.Tan(step / 4);
        for (var i = 0; i < count; i++)
        {
            var (sin0, cos0) = Math.SinCos(from + i * step);
            var (sin1, cos1) = Math.SinCos(from + (i + 1) * step);
            var control1 = new Point(cos0 - handle * sin0, sin0 + handle * cos0).Transform(place);
            var control2 = new Point(cos1 + handle * sin1, sin1 - handle * cos1).Transform(place);
            path.CubicTo(control1, control2, i == count - 1 ? end : new Point(cos1, sin1).Transform(place));
        }
    }

    private static Vector TurnedBack(Point vector, Matrix rotation) =>
        new(vector.X * rotation.M11 + vector.Y * rotation.M12, vector.X * rotation.M21 + vector.Y * rotation.M22);

    private static Point Middle(Point a, Point b) => new((a.X + b.X) / 2, (a.Y + b.Y) / 2);

    private static double Squared(double value) => value * value;
}
