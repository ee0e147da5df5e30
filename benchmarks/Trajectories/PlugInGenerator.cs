using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Benchmarks.Trajectories;

/// <summary>The lines that the SACETraj plug-in generates for a curve, after the notes on its code (sace-xps-agie.md 1.2 and 1.3), including its defects. Lines
/// as in its file. Millimetres.</summary>
internal sealed class PlugInGenerator
{
    private readonly IReadOnlyList<Segment> _segments;
    private readonly double[] _ends;
    private readonly Dictionary<Segment, double[]> _tables = [];

    private PlugInGenerator(IReadOnlyList<Segment> segments)
    {
        (_segments, _ends) = (segments, new double[segments.Count]);
        for (var i = 0; i < segments.Count; i++) _ends[i] = (i == 0 ? 0.0 : _ends[i - 1]) + segments[i].Length;
    }

    private double Length => _ends[^1];

    /// <summary>Number of samples that were tested in the search for the next points.</summary>
    private long _scanned;

    /// <summary>Dynamic density; empty for a curve shorter than the error.</summary>
    /// <exception cref="OverflowException">The error is 0: the number of samples is without limit.</exception>
    public static List<Point2D> Dynamic(IReadOnlyList<Segment> segments, double error) => Dynamic(segments, error, out _);

    /// <param name="scanned">Number of samples that were tested in the search for the next points, again for every point.</param>
    public static List<Point2D> Dynamic(IReadOnlyList<Segment> segments, double error, out long scanned)
    {
        scanned = 0;
        var curve = new PlugInGenerator(segments);
        var (spacing, length) = (error / 2.0, curve.Length);
        var count = checked((int)Math.Ceiling(length / spacing));
        if (length < error) return [];
        var (bends, nextCorner) = curve.Sample(count, length / count);
        var (lines, s, isFirst) = (curve.Head(), 0.0, true);
        while (s < length)
        {
            var step = isFirst ? (length - s) / 2.0 : length - s;
            isFirst = false;
            while (step >= error && !curve.Fits(bends, nextCorner, count, length, s, step, error)) step /= 2.0;
            if (step >= error || length - s < error)
            {
                s = s + step > length - 1e-9 ? length : s + step;
                if (s < length) lines.Add(curve.At(s));
                continue;
            }

            lines.RemoveAt(lines.Count - 1);
            s = Math.Max(0.0, s - (error / 8.0));
            for (var i = 0; i < 16 && s < length; i++) lines.Add(curve.At(s = Math.Min(length, s + (error / 8.0))));
        }

        scanned = curve._scanned;
        return curve.Ended(lines);
    }

    /// <summary>Uniform density.</summary>
    public static List<Point2D> Uniform(IReadOnlyList<Segment> segments, double longest)
    {
        var curve = new PlugInGenerator(segments);
        var step = curve.Length / Math.Ceiling(curve.Length / longest);
        var lines = curve.Head();
        for (var s = step; s < curve.Length; s += step) lines.Add(curve.At(s));
        return curve.Ended(lines);
    }

    /// <summary>The text of its file in the culture of the computer.</summary>
    public static string Text(IEnumerable<Point2D> lines, CultureInfo culture) => string.Concat(lines.Select(line => string.Create(culture, $"{line.X}, {line.Y}, {0.0}\r\n")));

    private List<Point2D> Head() => [At(0.0) - (At(1e-5 * Length) - At(0.0)), At(0.0)];

    private List<Point2D> Ended(List<Point2D> lines)
    {
        lines.Add(At(Length));
        lines.Add(At(Length) + (At(Length) - At(Length - (1e-5 * Length))));
        return lines;
    }

    /// <summary>Curvatures, and the next sample at or after each whose tangent turns too fast for its curvature.</summary>
    private (double[] Bends, int[] NextCorner) Sample(int count, double spacing)
    {
        var (bends, tangents, next) = (new double[count + 1], new Vector2D[count + 1], new int[count + 2]);
        for (var i = 0; i <= count; i++)
        {
            var (segment, fraction) = PlaceOf(i * spacing);
            (tangents[i], bends[i]) = (segment.TangentAt(fraction), Curvature(segment, fraction));
        }

        next[count] = next[count + 1] = int.MaxValue;
        for (var i = count - 1; i >= 0; i--) next[i] = i > 0 && (tangents[i + 1] - tangents[i - 1]).Length / (2.0 * spacing) > (Math.Sqrt(2.0) * bends[i]) + 1e-9 ? i : next[i + 1];
        return (bends, next);
    }

    private bool Fits(double[] bends, int[] nextCorner, int count, double length, double from, double step, double error)
    {
        var (first, last) = ((int)Math.Ceiling(from / length * count), (int)Math.Floor((from + step) / length * count));
        _scanned += Math.Max(0, Math.Min(last, count) - first + 1); // it takes the largest curvature of all of them; here the first that is too large will do
        if (nextCorner[Math.Min(first, count + 1)] <= last) return false;
        for (var i = first; i <= Math.Min(last, count); i++)
        {
            if (bends[i] * step * step / 24.0 > error) return false;
        }

        return true;
    }

    private static double Curvature(Segment segment, double fraction)
    {
        const double Small = 1e-4;
        if (segment.Kind == SegmentKind.Line) return 0.0;
        if (!segment.IsFreeCurve) return 1.0 / segment.Arc.Radius;
        var (from, to) = (Math.Max(0.0, fraction - Small), Math.Min(1.0, fraction + Small));
        return Math.Abs(segment.TangentAt(from).TurnTo(segment.TangentAt(to)).Radians) / segment.PointAt(from).DistanceTo(segment.PointAt(to));
    }

    private Point2D At(double length)
    {
        var (segment, fraction) = PlaceOf(length);
        return segment.PointAt(fraction);
    }

    private (Segment Segment, double Fraction) PlaceOf(double length)
    {
        var index = 0;
        while (index < _ends.Length - 1 && _ends[index] < length) index++;
        var segment = _segments[index];
        var along = Math.Clamp(length - (_ends[index] - segment.Length), 0.0, segment.Length);
        return (segment, segment.IsFreeCurve ? FractionOf(segment, along) : along / segment.Length);
    }

    /// <summary>By the lengths of 4096 chords.</summary>
    private double FractionOf(Segment segment, double along)
    {
        const int Chords = 4096;
        if (!_tables.TryGetValue(segment, out var table))
        {
            table = new double[Chords + 1];
            for (var i = 1; i <= Chords; i++) table[i] = table[i - 1] + segment.PointAt((i - 1.0) / Chords).DistanceTo(segment.PointAt((double)i / Chords));
            for (var i = 1; i <= Chords; i++) table[i] *= segment.Length / table[Chords];
            _tables[segment] = table;
        }

        var found = Array.BinarySearch(table, along);
        if (found >= 0) return (double)found / Chords;
        var cell = Math.Clamp(~found - 1, 0, Chords - 1);
        return (cell + ((along - table[cell]) / (table[cell + 1] - table[cell]))) / Chords;
    }
}
