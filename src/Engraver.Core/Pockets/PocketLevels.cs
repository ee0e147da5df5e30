using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>The strokes of a pocket at its depths, each region from the top down before the next, with ramps and helices as chords.</summary>
public static class PocketLevels
{
    /// <param name="pocket">Planned passes.</param>
    /// <param name="options">Options with which the pocket was planned.</param>
    /// <param name="depths">Levels and entry.</param>
    public static IReadOnlyList<PocketCut> Of(PocketResult pocket, PocketOptions options, PocketDepths depths)
    {
        var cuts = new List<PocketCut>();
        foreach (var region in pocket.Strokes.GroupBy(stroke => stroke.Region))
        {
            var descent = new PocketDescent([.. pocket.Walls[region.Key].SelectMany(wall => wall)], options, depths);
            var top = 0.0;
            foreach (var z in depths.Heights)
            {
                foreach (var stroke in region) cuts.Add(descent.To(stroke, top, z));
                top = z;
            }
        }

        return cuts;
    }
}

/// <summary>Descents to the strokes of one region.</summary>
internal sealed class PocketDescent
{
    /// <summary>Radii of a helix, in tool radii: the largest leaves no core.</summary>
    private const double MaxHelixRadius = 0.9;

    private const double MinHelixRadius = 0.1;

    /// <summary>Length of a back-and-forth ramp, in tool radii: on a shorter ramp the tool would rotate in place.</summary>
    private const double ShortestRamp = 0.1;

    /// <summary>Millimetres by which a helix may be nearer to a wall than the radius.</summary>
    private const double Rounding = 1e-6;

    private readonly SweptReach _walls;
    private readonly PocketOptions _options;
    private readonly PocketDepths _depths;

    public PocketDescent(IReadOnlyList<PathPiece> walls, PocketOptions options, PocketDepths depths) =>
        (_walls, _options, _depths) = (new SweptReach(walls, options.ToolRadius), options, depths);

    public PocketCut To(PocketStroke stroke, double top, double z)
    {
        if (_depths.Entry == PocketEntry.Plunge || z >= top) return new PocketCut(stroke, z, [], PocketEntry.Plunge);
        var length = (top - z) / Math.Tan(_depths.RampAngle.Radians);
        if (_depths.Entry == PocketEntry.Helix && Helix(stroke, length) is { } screw) return new PocketCut(stroke, z, WithHeights(screw, top, z), PocketEntry.Helix);
        return Ramp(stroke, length) is { } ramp ? new PocketCut(stroke, z, WithHeights(ramp, top, z), PocketEntry.Ramp) : new PocketCut(stroke, z, [], PocketEntry.Plunge);
    }

    /// <summary>Turns about a centre on the pocket's side of the start, ending in the direction of the first pass; null when no circle of a useful size is
    /// clear of the walls.</summary>
    private List<Point2D>? Helix(PocketStroke stroke, double length)
    {
        var tangent = stroke.Moves[0].Segment.StartTangent;
        for (var radius = MaxHelixRadius * _options.ToolRadius; radius >= MinHelixRadius * _options.ToolRadius; radius /= 2.0)
        {
            var centre = stroke.Start + (new Vector2D(-tangent.Y, tangent.X) * radius);
            if (_walls.Distance(centre) < _options.ToolRadius + radius - Rounding) continue;
            var (turn, end) = (length / radius, (stroke.Start - centre).Direction.Radians);
            var count = Math.Max(1, (int)Math.Ceiling(turn / ChordAngle(radius)));
            var points = new List<Point2D>(count + 1);
            for (var i = 0; i < count; i++) points.Add(On(centre, radius, end - (turn * (count - i) / count)));
            points.Add(stroke.Start);
            return points;
        }

        return null;
    }

    /// <summary>Along the moves before the first link: repeatedly around when they are closed, back and forth when they are open; null when they are too short
    /// for a descent.</summary>
    private List<Point2D>? Ramp(PocketStroke stroke, double length)
    {
        List<PathPiece> first = [.. stroke.Moves.TakeWhile(move => !move.IsLink).Select(move => PathPiece.FromSegment(move.Segment))];
        if (first.Count == 0) first.Add(PathPiece.FromSegment(stroke.Moves[0].Segment));
        var (points, total) = (Points(first), first.Sum(piece => piece.Length));
        if (total < ShortestRamp * _options.ToolRadius) return null;
        if (first[^1].End.IsNear(first[0].Start, PassChain.Joint))
        {
            var turns = Math.Max(1, (int)Math.Ceiling(length / total));
            List<Point2D> round = [.. Enumerable.Range(0, turns).SelectMany(_ => points.Skip(1))];
            return LastOf([points[0], .. round], length);
        }

        var trips = Math.Max(1, (int)Math.Ceiling(length / (2.0 * total)));
        var there = FirstOf(points, length / (2.0 * trips));
        List<Point2D> back = [.. Enumerable.Reverse(there)];
        return [there[0], .. Enumerable.Range(0, trips).SelectMany(_ => there.Skip(1).Concat(back.Skip(1)))];
    }

    /// <summary>Chords on the pocket's side of every arc: inside an arc that turns left, around an arc that turns right.</summary>
    private List<Point2D> Points(List<PathPiece> pieces)
    {
        List<Point2D> points = [pieces[0].Start];
        foreach (var piece in pieces)
        {
            if (piece.IsArc) AddChords(piece, points);
            points.Add(piece.End);
        }

        return points;
    }

    private void AddChords(in PathPiece arc, List<Point2D> points)
    {
        var count = Math.Max(2, (int)Math.Ceiling(Math.Abs(arc.Sweep) / ChordAngle(arc.Radius)));
        var step = arc.Sweep / count;
        if (arc.Sweep > 0.0) for (var i = 1; i < count; i++) points.Add(On(arc.Centre, arc.Radius, arc.From + (i * step)));
        else for (var i = 0; i < count; i++) points.Add(On(arc.Centre, arc.Radius / Math.Cos(step / 2.0), arc.From + ((i + 0.5) * step)));
    }

    private double ChordAngle(double radius) => 2.0 * Math.Acos(Math.Max(0.5, 1.0 - (_options.MaxErrorMm / radius)));

    private static Point2D On(Point2D centre, double radius, double turn) => centre + new Vector2D(radius * Math.Cos(turn), radius * Math.Sin(turn));

    private static List<Point2D> FirstOf(List<Point2D> points, double length)
    {
        List<Point2D> first = [points[0]];
        for (var i = 1; i < points.Count && length > 0.0; i++)
        {
            var step = points[i].DistanceTo(points[i - 1]);
            first.Add(step <= length ? points[i] : points[i - 1] + ((points[i] - points[i - 1]) * (length / step)));
            length -= step;
        }

        return first;
    }

    private static List<Point2D> LastOf(List<Point2D> points, double length)
    {
        points.Reverse();
        var last = FirstOf(points, length);
        last.Reverse();
        return last;
    }

    /// <summary>Descends evenly along the path.</summary>
    private static List<(Point2D, double)> WithHeights(List<Point2D> points, double top, double z)
    {
        var total = 0.0;
        for (var i = 1; i < points.Count; i++) total += points[i].DistanceTo(points[i - 1]);
        var (way, along) = (new List<(Point2D, double)> { (points[0], top) }, 0.0);
        for (var i = 1; i < points.Count; i++)
        {
            along += points[i].DistanceTo(points[i - 1]);
            way.Add((points[i], i + 1 == points.Count ? z : top + ((z - top) * along / total)));
        }

        return way;
    }
}
