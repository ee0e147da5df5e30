using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Unions;

namespace Engraver.TestKit;

/// <summary>Judges a union by where horizontal lines cross the contours: arcs are divided at their highest and lowest points, and x follows from the equation
/// of the circle.</summary>
public sealed class UnionWitness
{
    private readonly Segment[] _given;
    private readonly Part[] _parts;
    private readonly Bounds2D _box;
    private readonly double _size;

    public UnionWitness(IReadOnlyList<IReadOnlyList<Segment>> contours)
    {
        _given = [.. contours.SelectMany(contour => contour)];
        _parts = Divided(_given);
        _box = _given.Aggregate(Bounds2D.Empty, (box, segment) => box.Union(segment.Bounds));
        _size = _box.Width + _box.Height;
    }

    /// <summary>The first fault of a result; null for none.</summary>
    /// <param name="result">The union.</param>
    /// <param name="grid">Points along each side of the box, and a tenth of the horizontal lines by which the area is measured.</param>
    public string? Fault(UnionResult result, int grid)
    {
        if (!result.IsComplete) return FormattableString.Invariant($"{result.Unresolved.Count} places are unresolved, the first is {result.Unresolved[0]}");
        var parts = Divided([.. result.Contours.SelectMany(contour => contour)]);
        return FaultOfEnds(result) ?? FaultOfPoints(parts, grid) ?? FaultOfBoundary(result, parts) ?? FaultOfArea(result, 10 * grid);
    }

    /// <summary>Area with a winding number other than 0, by the widths on horizontal lines.</summary>
    public double CoveredArea(int lines)
    {
        var step = _box.Height / lines;
        var sum = 0.0;
        for (var i = 0; i < lines; i++)
        {
            var y = _box.MinY + ((i + 0.5) * step);
            var (winding, last) = (0, 0.0);
            foreach (var (x, turn) in _parts.Where(part => part.Meets(y)).Select(part => (X: part.At(y), part.Turn)).OrderBy(crossing => crossing.X))
            {
                if (winding != 0) sum += step * (x - last);
                winding += turn;
                last = x;
            }
        }

        return sum;
    }

    private static string? FaultOfEnds(UnionResult result)
    {
        foreach (var contour in result.Contours)
        {
            for (var i = 0; i < contour.Count; i++)
            {
                var next = contour[(i + 1) % contour.Count].Start;
                if (contour[i].End != next) return FormattableString.Invariant($"{contour[i].End} is not {next}");
            }
        }

        return null;
    }

    private string? FaultOfPoints(Part[] result, int grid)
    {
        for (var row = 0; row < grid; row++)
        {
            for (var column = 0; column < grid; column++)
            {
                var place = new Point2D(_box.MinX + (_box.Width * (column + 0.4137) / grid), _box.MinY + (_box.Height * (row + 0.3719) / grid));
                if (Distance(place) < 1e-7 * _size) continue;
                var (given, found) = (Winding(_parts, place), Winding(result, place));
                if (found != (given == 0 ? 0 : 1)) return FormattableString.Invariant($"the result runs {found} times around {place}, the contours {given} times");
            }
        }

        return null;
    }

    /// <summary>A point of the result that is not on a given contour, or without area on its left, or with area on its right.</summary>
    private string? FaultOfBoundary(UnionResult result, Part[] parts)
    {
        var beside = 1e-6 * _size;
        foreach (var segment in result.Contours.SelectMany(contour => contour))
        {
            if (segment.Length < 100.0 * beside) continue;
            foreach (var at in new[] { 0.1371, 0.4637, 0.7719 })
            {
                var (place, tangent) = (segment.PointAt(at), segment.TangentAt(at));
                if (Distance(place) > 1e-7 * _size) return FormattableString.Invariant($"{place} of the result is {Distance(place):E2} away from the contours");
                var (left, right) = (place + (new Vector2D(-tangent.Y, tangent.X) * beside), place + (new Vector2D(tangent.Y, -tangent.X) * beside));
                if (Distance(left) < 0.9999 * beside || Distance(right) < 0.9999 * beside) continue;
                var (onLeft, onRight) = (Winding(_parts, left), Winding(_parts, right));
                if (onLeft == 0 || onRight != 0) return FormattableString.Invariant($"{place} of the result has winding number {onLeft} on its left, {onRight} on its right");
                if (Winding(parts, left) != 1 || Winding(parts, right) != 0) return FormattableString.Invariant($"the result crosses itself at {place}");
            }
        }

        return null;
    }

    private string? FaultOfArea(UnionResult result, int lines)
    {
        var (covered, found) = (CoveredArea(lines), result.Contours.Sum(ChainArea.Of));
        return Math.Abs(covered - found) > 4.0 * _size * _size / lines ? FormattableString.Invariant($"the area is {found:R}, not {covered:R}") : null;
    }

    private double Distance(Point2D place) => _given.Min(segment => segment.DistanceTo(place));

    private static int Winding(Part[] parts, Point2D place) => parts.Where(part => part.Meets(place.Y) && part.At(place.Y) > place.X).Sum(part => part.Turn);

    private static Part[] Divided(Segment[] segments) => [.. segments.SelectMany(segment => segment.Kind == SegmentKind.Line ? [new Part(segment.Start, segment.End, default, 0.0)] : Divided(segment))];

    private static IEnumerable<Part> Divided(Segment segment)
    {
        var arc = segment.Arc;
        var (from, sweep) = (arc.Start.Radians, arc.Sweep.Radians);
        var (low, high) = (Math.Min(from, from + sweep), Math.Max(from, from + sweep));
        var turns = new List<double>();
        for (var k = Math.Ceiling((low - (Math.PI / 2.0)) / Math.PI); (k * Math.PI) + (Math.PI / 2.0) < high; k++)
        {
            if ((k * Math.PI) + (Math.PI / 2.0) > low) turns.Add((k * Math.PI) + (Math.PI / 2.0));
        }

        if (sweep < 0.0) turns.Reverse();
        var (start, angle) = (segment.Start, from);
        foreach (var turn in turns.Append(from + sweep))
        {
            var end = turn == from + sweep ? segment.End : new Point2D(arc.Centre.X, arc.Centre.Y + (Math.Sin(turn) > 0.0 ? arc.Radius : -arc.Radius));
            yield return new Part(start, end, arc.Centre, Math.Cos((angle + turn) / 2.0) > 0.0 ? arc.Radius : -arc.Radius);
            (start, angle) = (end, turn);
        }
    }

    /// <summary>A line, or a part of an arc that only rises or only falls.</summary>
    /// <param name="Radius">0 for a line; negative on the left half of its circle.</param>
    private readonly record struct Part(Point2D Start, Point2D End, Point2D Centre, double Radius)
    {
        public int Turn => End.Y > Start.Y ? 1 : -1;

        public bool Meets(double y) => Start.Y > y != End.Y > y;

        public double At(double y)
        {
            if (Radius == 0.0) return Start.X + ((y - Start.Y) / (End.Y - Start.Y) * (End.X - Start.X));
            var height = y - Centre.Y;
            return Centre.X + (Math.Sign(Radius) * Math.Sqrt(Math.Max(0.0, (Radius - height) * (Radius + height))));
        }
    }
}
