using Engraver.Core.Geometry;
using Engraver.Core.Offsets;

namespace Engraver.Core.Tests.Offsets;

/// <summary>Judges an offset by plain arithmetic that is independent of the product: distances to every piece, winding numbers of finely divided
/// loops.</summary>
internal sealed class OffsetWitness
{
    private const int PartsOfTurn = 720;
    private readonly (double X, double Y)[][] _source;
    private readonly Segment[] _segments;

    public OffsetWitness(IReadOnlyList<OffsetContour> contours)
    {
        _segments = [.. contours.SelectMany(contour => contour.Segments)];
        _source = [.. contours.Where(contour => contour.Closed).Select(contour => Divided(contour.Segments))];
    }

    /// <summary>Distance to the nearest drawn piece.</summary>
    public double Distance(double x, double y) => _segments.Min(segment => Distance(segment, x, y));

    /// <summary>Inside an odd number of the closed contours.</summary>
    public bool IsInside(double x, double y) => (_source.Sum(loop => Math.Abs(Winding(loop, x, y)) & 1) & 1) == 1;

    /// <summary>The first fault of a round-joined offset of closed contours, in or out; null for none.</summary>
    /// <param name="result">The result to be judged.</param>
    /// <param name="distance">The requested distance.</param>
    /// <param name="inside">True for in, false for out.</param>
    /// <param name="grid">Points along the longer side of the box.</param>
    public string? FaultOfRegion(OffsetResult result, double distance, bool inside, int grid)
    {
        if (FaultOfLoops(result, distance) is { } fault) return fault;
        if (result.Loops.Any(loop => !loop.Closed)) return "a loop is open";
        var loops = result.Loops.Select(loop => Divided(loop.Segments)).ToArray();
        var box = _segments.Aggregate(Bounds2D.Empty, (all, segment) => all.Union(segment.Bounds)).Grown(1.3 * distance);
        var step = Math.Max(box.Width, box.Height) / grid;
        for (var y = box.MinY + (0.37 * step); y < box.MaxY; y += step)
        {
            for (var x = box.MinX + (0.41 * step); x < box.MaxX; x += step)
            {
                var near = Distance(x, y);
                if (Math.Abs(near - distance) < 1e-3 * (distance + box.Width)) continue;
                var (isInside, winding) = (IsInside(x, y), loops.Sum(loop => Winding(loop, x, y)));
                var expected = inside ? isInside && near > distance : isInside || near < distance;
                if (winding != (expected ? 1 : 0)) return FormattableString.Invariant($"winding number {winding} at {x:R},{y:R}, which is {near:R} from the drawing and {(isInside ? "in" : "out")}side");
            }
        }

        return null;
    }

    /// <summary>Ends that do not meet exactly, points that do not have the distance.</summary>
    public string? FaultOfLoops(OffsetResult result, double distance)
    {
        if (result.Unresolved.Count > 0) return FormattableString.Invariant($"{result.Unresolved.Count} unresolved, at {result.Unresolved[0]}");
        foreach (var loop in result.Loops)
        {
            for (var i = 0; i < loop.Segments.Count; i++)
            {
                var next = loop.Segments[(i + 1) % loop.Segments.Count];
                if ((loop.Closed || i + 1 < loop.Segments.Count) && loop.Segments[i].End != next.Start) return FormattableString.Invariant($"{loop.Segments[i].End} is not {next.Start}");
                foreach (var at in new[] { 0.0, 0.13, 0.5, 0.77, 1.0 })
                {
                    var place = at == 0.0 ? loop.Segments[i].Start : loop.Segments[i].PointAt(at);
                    var off = Distance(place.X, place.Y) - distance;
                    if (Math.Abs(off) > 1e-9) return FormattableString.Invariant($"{place} is {off:E2} off the distance");
                }
            }
        }

        return null;
    }

    /// <summary>A point at the distance on the left (or right) of a piece or corner to which no drawn piece is nearer, but that is not on the result; null for
    /// none.</summary>
    public string? Missing(OffsetResult result, double distance, bool left)
    {
        var found = result.Loops.SelectMany(loop => loop.Segments).ToArray();
        foreach (var segment in _segments)
        {
            foreach (var at in new[] { 0.07, 0.31, 0.5, 0.66, 0.97 })
            {
                var (place, tangent) = (segment.PointAt(at), segment.TangentAt(at));
                var (dx, dy) = left ? (-tangent.Y, tangent.X) : (tangent.Y, -tangent.X);
                var (x, y) = (place.X + (dx * distance), place.Y + (dy * distance));
                if (Distance(x, y) < distance - 1e-10 || Distance(x + (dx * 1e-6), y + (dy * 1e-6)) < distance + 0.9e-6) continue; // covered, or the middle of two walls just as far apart
                if (!found.Any(piece => Distance(piece, x, y) < 1e-6)) return FormattableString.Invariant($"{x:R},{y:R} is missing");
            }
        }

        return null;
    }

    /// <summary>Area by counting, even-odd, with an error of about the length times the cell.</summary>
    public static double CountedArea(OffsetResult result, int grid)
    {
        var loops = result.Loops.Select(loop => Divided(loop.Segments)).ToArray();
        var box = result.Loops.SelectMany(loop => loop.Segments).Aggregate(Bounds2D.Empty, (all, segment) => all.Union(segment.Bounds));
        var step = Math.Max(box.Width, box.Height) / grid;
        var count = 0;
        for (var y = box.MinY + (step / 2.0); y < box.MaxY; y += step)
        {
            for (var x = box.MinX + (step / 2.0); x < box.MaxX; x += step) count += loops.Sum(loop => Winding(loop, x, y));
        }

        return count * step * step;
    }

    private static (double X, double Y)[] Divided(IReadOnlyList<Segment> segments) => [.. segments.SelectMany(segment =>
    {
        if (segment.Kind == SegmentKind.Line) return [(segment.Start.X, segment.Start.Y)];
        var arc = segment.Arc;
        var parts = 2 + (int)(Math.Abs(arc.Sweep.Degrees) / 360.0 * PartsOfTurn);
        return Enumerable.Range(0, parts).Select(i =>
        {
            var angle = (arc.Start.Degrees + (arc.Sweep.Degrees * i / parts)) * Math.PI / 180.0;
            return (arc.Centre.X + (arc.Radius * Math.Cos(angle)), arc.Centre.Y + (arc.Radius * Math.Sin(angle)));
        });
    })];

    private static int Winding((double X, double Y)[] loop, double x, double y)
    {
        var winding = 0;
        for (var i = 0; i < loop.Length; i++)
        {
            var (a, b) = (loop[i], loop[(i + 1) % loop.Length]);
            if (a.Y > y == b.Y > y) continue;
            if (a.X + ((y - a.Y) / (b.Y - a.Y) * (b.X - a.X)) > x) winding += b.Y > a.Y ? 1 : -1;
        }

        return winding;
    }

    private static double Distance(Segment segment, double x, double y)
    {
        if (segment.Kind == SegmentKind.Line)
        {
            var (dx, dy) = (segment.End.X - segment.Start.X, segment.End.Y - segment.Start.Y);
            var at = dx == 0.0 && dy == 0.0 ? 0.0 : Math.Clamp((((x - segment.Start.X) * dx) + ((y - segment.Start.Y) * dy)) / ((dx * dx) + (dy * dy)), 0.0, 1.0);
            return Hypotenuse(x - segment.Start.X - (at * dx), y - segment.Start.Y - (at * dy));
        }

        var arc = segment.Arc;
        var angle = Math.Atan2(y - arc.Centre.Y, x - arc.Centre.X) * 180.0 / Math.PI;
        var ahead = (angle - arc.Start.Degrees) * Math.Sign(arc.Sweep.Degrees) % 360.0;
        if (ahead < 0.0) ahead += 360.0;
        if (ahead <= Math.Abs(arc.Sweep.Degrees)) return Math.Abs(Hypotenuse(x - arc.Centre.X, y - arc.Centre.Y) - arc.Radius);
        return Math.Min(Hypotenuse(x - segment.Start.X, y - segment.Start.Y), Hypotenuse(x - segment.End.X, y - segment.End.Y));
    }

    private static double Hypotenuse(double x, double y) => Math.Sqrt((x * x) + (y * y));
}
