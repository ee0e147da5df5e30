using Engraver.Core.Geometry;

namespace Engraver.Benchmarks.Trajectories;

/// <summary>The curve that a controller makes of the lines of a spline file, evaluated from the definition of the uniform Catmull-Rom spline, and its
/// distance from the source. Shares no code with the generator.</summary>
internal sealed class SplineEvaluation
{
    private readonly List<(double X, double Y)> _places = [];

    private readonly IReadOnlyList<Point2D> _lines;
    private readonly int _stepsOfSegment;

    public SplineEvaluation(IReadOnlyList<Point2D> lines, int stepsOfSegment = 60)
    {
        (_lines, _stepsOfSegment) = (lines, stepsOfSegment);
        for (var i = 1; i + 2 < lines.Count; i++)
        {
            for (var k = i == 1 ? 0 : 1; k <= stepsOfSegment; k++) _places.Add(At(lines[i - 1], lines[i], lines[i + 1], lines[i + 2], (double)k / stepsOfSegment));
        }
    }

    public IReadOnlyList<(double X, double Y)> Places => _places;

    /// <summary>Largest distance of a point of the spline from the source.</summary>
    public double FromSource(IReadOnlyList<Segment> source) => _places.Max(place => source.Min(segment => segment.DistanceTo(new Point2D(place.X, place.Y))));

    /// <summary>Largest distance of a point of the source from the spline.</summary>
    public double ToSource(IReadOnlyList<Segment> source, int steps = 200)
    {
        var largest = 0.0;
        foreach (var segment in source)
        {
            for (var k = 0; k <= steps; k++)
            {
                var place = segment.PointAt((double)k / steps);
                largest = Math.Max(largest, Nearest(place.X, place.Y));
            }
        }

        return largest;
    }

    /// <summary>The nearest of the points, then the nearest of the curve around it; near the end of a closed curve that may be before its start.</summary>
    private double Nearest(double x, double y)
    {
        double From((double X, double Y) place) => double.Hypot(place.X - x, place.Y - y);
        var nearest = 0;
        for (var i = 1; i < _places.Count; i++)
        {
            if (From(_places[i]) < From(_places[nearest])) nearest = i;
        }

        var around = Around(nearest, From);
        return nearest == 0 ? Math.Min(around, Around(_places.Count - 1, From)) : nearest == _places.Count - 1 ? Math.Min(around, Around(0, From)) : around;
    }

    private double Around(int nearest, Func<(double X, double Y), double> from)
    {
        var (low, high) = (Math.Max(0.0, nearest - 1.0), Math.Min(_places.Count - 1.0, nearest + 1.0));
        for (var round = 0; round < 60; round++)
        {
            var (first, second) = (low + ((high - low) / 3.0), high - ((high - low) / 3.0));
            if (from(PlaceAt(first)) < from(PlaceAt(second))) high = second;
            else low = first;
        }

        return from(PlaceAt((low + high) / 2.0));
    }

    /// <summary>The point at a number of steps from the start.</summary>
    private (double X, double Y) PlaceAt(double steps)
    {
        var segment = Math.Min((int)(steps / _stepsOfSegment), _lines.Count - 4);
        return At(_lines[segment], _lines[segment + 1], _lines[segment + 2], _lines[segment + 3], (steps / _stepsOfSegment) - segment);
    }

    /// <summary>The matrix form of Catmull and Rom with tension 1/2.</summary>
    private static (double X, double Y) At(Point2D a, Point2D b, Point2D c, Point2D d, double u) => (Value(a.X, b.X, c.X, d.X, u), Value(a.Y, b.Y, c.Y, d.Y, u));

    private static double Value(double a, double b, double c, double d, double u) =>
        0.5 * ((2.0 * b) + ((c - a) * u) + (((2.0 * a) - (5.0 * b) + (4.0 * c) - d) * u * u) + (((3.0 * b) - a - (3.0 * c) + d) * u * u * u));
}
