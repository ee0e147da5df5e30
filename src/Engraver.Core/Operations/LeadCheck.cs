using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Operations;

/// <summary>Measures the leads of strokes: every lead is at the radius of the tool or farther from all contours. The contours are divided into chords, which
/// are found by the cells of a grid, and the distance is that of a point from a chord.</summary>
internal sealed class LeadCheck
{
    /// <summary>Largest distance of a chord from its contour, mm.</summary>
    private const double ChordError = 1e-3;

    /// <summary>Part of the radius by which a lead may be nearer: it is planned by steps of this part.</summary>
    private const double PlannedStep = 0.01;

    private const double CellSize = 5.0;
    private readonly Dictionary<(int X, int Y), List<(Point2D From, Point2D To)>> _cells = [];

    /// <param name="contours">Of every part that is profiled or cleared, millimetres.</param>
    public LeadCheck(IEnumerable<Segment> contours)
    {
        foreach (var contour in contours)
        {
            foreach (var segment in contour.IsFreeCurve ? BiarcFit.Fit(contour.Curve, ChordError / 2.0) : [contour])
            {
                var count = segment.Kind == SegmentKind.Line ? 1 : Math.Max(4, (int)Math.Ceiling(segment.Length / Math.Sqrt(4.0 * ChordError * segment.Arc.Radius)));
                for (var i = 0; i < count; i++) Add(segment.PointAt((double)i / count), segment.PointAt((i + 1.0) / count));
            }
        }
    }

    /// <summary>A place of a lead that is nearer than allowed; null when there is none.</summary>
    /// <param name="isAside">Descents are beside the contour too.</param>
    /// <param name="distance">Of the tool's centre from the contours: its radius, and the stock that is left.</param>
    /// <param name="tolerance">Of the path beside its contour, mm.</param>
    public Point2D? Fault(IEnumerable<StrokeMove> moves, bool isAside, double distance, double tolerance)
    {
        var least = (distance * (1.0 - PlannedStep)) - tolerance - ChordError - 1e-4;
        foreach (var lead in moves.Where(move => move.Role == StrokeRole.Lead || (isAside && move.Role == StrokeRole.Ramp)).Select(move => move.Segment))
        {
            var count = Math.Max(2, (int)Math.Ceiling(lead.Length / Math.Max(1e-3, Math.Min(0.05, 0.2 * distance))));
            for (var i = 0; i <= count; i++)
            {
                var place = lead.PointAt((double)i / count);
                if (IsNearer(place, least)) return place;
            }
        }

        return null;
    }

    private bool IsNearer(Point2D place, double distance)
    {
        for (var x = CellOf(place.X - distance); x <= CellOf(place.X + distance); x++)
        {
            for (var y = CellOf(place.Y - distance); y <= CellOf(place.Y + distance); y++)
            {
                if (_cells.TryGetValue((x, y), out var chords) && chords.Exists(chord => Distance(place, chord.From, chord.To) < distance)) return true;
            }
        }

        return false;
    }

    /// <summary>A chord is divided so that each part is in few cells.</summary>
    private void Add(Point2D from, Point2D to)
    {
        var count = Math.Max(1, (int)Math.Ceiling(from.DistanceTo(to) / CellSize));
        for (var i = 0; i < count; i++)
        {
            var (start, end) = (from + ((to - from) * ((double)i / count)), from + ((to - from) * ((i + 1.0) / count)));
            for (var x = CellOf(Math.Min(start.X, end.X)); x <= CellOf(Math.Max(start.X, end.X)); x++)
            {
                for (var y = CellOf(Math.Min(start.Y, end.Y)); y <= CellOf(Math.Max(start.Y, end.Y)); y++)
                {
                    if (!_cells.TryGetValue((x, y), out var chords)) _cells[(x, y)] = chords = [];
                    chords.Add((start, end));
                }
            }
        }
    }

    private static int CellOf(double along) => (int)Math.Floor(along / CellSize);

    /// <summary>Distance of a point from a chord by its height over it, or from the nearer end.</summary>
    private static double Distance(Point2D place, Point2D from, Point2D to)
    {
        var (way, toPlace) = (to - from, place - from);
        var along = toPlace.Dot(way);
        if (along <= 0.0) return toPlace.Length;
        return along >= way.LengthSquared ? place.DistanceTo(to) : Math.Abs(way.Cross(toPlace)) / way.Length;
    }
}
