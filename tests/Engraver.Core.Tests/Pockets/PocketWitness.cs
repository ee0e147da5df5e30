using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Pockets;
using Engraver.Core.Tests.Offsets;

namespace Engraver.Core.Tests.Pockets;

/// <summary>Judges a pocket by plain arithmetic on a raster that is independent of the planner: distances to walls and passes.</summary>
internal sealed class PocketWitness(IReadOnlyList<OffsetContour> drawn, PocketOptions options)
{
    private const double Slack = 2e-6;
    private const int Parts = 40;
    private readonly OffsetWitness _walls = new(drawn);

    /// <summary>The first fault; null for none.</summary>
    /// <param name="result">The result to be judged.</param>
    /// <param name="grid">Raster points along the longer side.</param>
    public string? Fault(PocketResult result, int grid) =>
        FaultOfAreas(result) ?? FaultOfGouges(result) ?? FaultOfStrokes(result) ?? FaultOfLinks(result) ?? FaultOfRaster(result, grid);

    private static string? FaultOfAreas(PocketResult result)
    {
        if (result.Unresolved.Count > 0) return "an offset was not closed";
        if (result.LeftStanding is [var place, ..]) return FormattableString.Invariant($"{result.UncoveredArea:E2} mm2 left standing, first at {place}");
        return Math.Abs((result.Coverage ?? 1.0) - 1.0) > 1e-6 ? FormattableString.Invariant($"coverage {result.Coverage:R}: {result.CoveredArea:R} of {result.ReachableArea:R}") : null;
    }

    /// <summary>Every position of the tool in every move is inside, the radius away from all walls.</summary>
    private string? FaultOfGouges(PocketResult result)
    {
        foreach (var segment in result.Passes.SelectMany(pass => pass.Segments).Concat(result.Strokes.SelectMany(stroke => stroke.Moves).Select(move => move.Segment)))
        {
            foreach (var at in new[] { 0.0, 0.11, 0.31, 0.5, 0.77, 1.0 })
            {
                var place = segment.PointAt(at);
                if (_walls.Distance(place.X, place.Y) < options.ToolRadius - Slack) return FormattableString.Invariant($"{place} is {_walls.Distance(place.X, place.Y):R} from a wall");
                if (!_walls.IsInside(place.X, place.Y)) return FormattableString.Invariant($"{place} is outside");
            }
        }

        return null;
    }

    /// <summary>Moves are continuous and contain all the passes.</summary>
    private static string? FaultOfStrokes(PocketResult result)
    {
        foreach (var stroke in result.Strokes)
        {
            for (var i = 1; i < stroke.Moves.Count; i++)
            {
                if (stroke.Moves[i - 1].Segment.End.DistanceTo(stroke.Moves[i].Segment.Start) > Slack) return FormattableString.Invariant($"a jump from {stroke.Moves[i - 1].Segment.End} to {stroke.Moves[i].Segment.Start}");
            }
        }

        var cut = result.Strokes.SelectMany(stroke => stroke.Moves).Where(move => !move.IsLink).Sum(move => move.Segment.Length);
        var passes = result.Passes.Sum(pass => pass.Segments.Sum(segment => segment.Length));
        return cut < passes - 1e-3 ? FormattableString.Invariant($"{cut:R} mm are cut, the passes are {passes:R} long") : null;
    }

    /// <summary>In the order of cutting, a link crosses uncut material at most by the amount by which the stepover exceeds the radius.</summary>
    private string? FaultOfLinks(PocketResult result)
    {
        var most = Math.Max(0.0, options.PassDistance - options.ToolRadius) + (options.ToolRadius * 1e-3);
        foreach (var region in result.Strokes.GroupBy(stroke => stroke.Region))
        {
            var cut = new List<Segment>();
            foreach (var moves in region.Select(stroke => stroke.Moves))
            {
                for (var i = 0; i < moves.Count; i++)
                {
                    if (moves[i].IsLink && Uncut(moves[i].Segment, cut) is var uncut && uncut > most + (moves[i].Segment.Length / Parts) && i > 0) return FormattableString.Invariant($"link {moves[i].Segment.Start} to {moves[i].Segment.End} leads {uncut:R} through the material");
                    cut.Add(moves[i].Segment);
                }
            }
        }

        return null;
    }

    private double Uncut(Segment link, List<Segment> cut)
    {
        var near = cut.Where(segment => Apart(segment.Bounds, link.Bounds) <= options.ToolRadius).ToList();
        var uncut = 0;
        for (var i = 0; i < Parts; i++)
        {
            var place = link.PointAt((i + 0.5) / Parts);
            if (!near.Exists(segment => segment.DistanceTo(place) <= options.ToolRadius + 1e-6)) uncut++;
        }

        return link.Length * uncut / Parts;
    }

    private static double Apart(Bounds2D a, Bounds2D b) => Math.Max(Math.Max(a.MinX - b.MaxX, b.MinX - a.MaxX), Math.Max(a.MinY - b.MaxY, b.MinY - a.MaxY));

    /// <summary>At every possible position of the tool its whole disc is within the radius of a pass.</summary>
    private string? FaultOfRaster(PocketResult result, int grid)
    {
        Segment[] passes = [.. result.Passes.SelectMany(pass => pass.Segments)];
        if (passes.Length == 0) return null;
        var tree = BoxTree.Build([.. passes.Select(segment => segment.Bounds)]);
        var box = drawn.SelectMany(contour => contour.Segments).Aggregate(Bounds2D.Empty, (all, segment) => all.Union(segment.Bounds));
        var step = Math.Max(box.Width, box.Height) / grid;
        for (var y = box.MinY + (0.37 * step); y < box.MaxY; y += step)
        {
            for (var x = box.MinX + (0.41 * step); x < box.MaxX; x += step)
            {
                if (_walls.Distance(x, y) < options.ToolRadius || !_walls.IsInside(x, y)) continue;
                for (var i = 0; i < 24; i++)
                {
                    var (radius, angle) = (options.ToolRadius * (i % 3) / 2.0, i / 3 * Math.PI / 4.0);
                    var place = new Point2D(x + (radius * Math.Cos(angle)), y + (radius * Math.Sin(angle)));
                    tree.Nearest(place, (item, from) => passes[item].DistanceTo(from), double.PositiveInfinity, out var distance);
                    if (distance > options.ToolRadius + 1e-6) return FormattableString.Invariant($"{place} is left standing, {distance:R} from the nearest pass");
                }
            }
        }

        return null;
    }
}
