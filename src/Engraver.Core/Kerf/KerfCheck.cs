using Engraver.Core.Geometry;
using Engraver.Core.Offsets;

namespace Engraver.Core.Kerf;

/// <summary>Compares a compensated path with the drawing in both directions, with its own computation of distances: no point of the path may be nearer than the
/// radius or farther from its source, and drawn parts that are not reached are found.</summary>
internal sealed class KerfCheck
{
    /// <summary>Fractions of a segment at which it is measured.</summary>
    private static readonly double[] s_fractions = [0.0, 0.13, 0.5, 0.81];

    /// <summary>Number of sample points on a drawn segment per radius of its length, and the minimum and maximum for a segment.</summary>
    private const double StepsPerRadius = 8.0;

    private const int MinSteps = 4;
    private const int MaxSteps = 200;

    private readonly IReadOnlyList<OffsetContour> _drawn;
    private readonly IReadOnlyList<OffsetLoop> _loops;
    private readonly KerfOptions _options;
    private readonly Segment[] _path;
    private readonly BoxTree _pathBoxes;
    private readonly Segment[] _source;
    private readonly BoxTree _sourceBoxes;

    public KerfCheck(IReadOnlyList<OffsetContour> drawn, IReadOnlyList<OffsetLoop> loops, KerfOptions options)
    {
        (_drawn, _loops, _options) = (drawn, loops, options);
        _path = [.. loops.SelectMany(loop => loop.Segments)];
        _source = [.. drawn.SelectMany(contour => contour.Segments)];
        (_pathBoxes, _sourceBoxes) = (BoxTree.Build([.. _path.Select(segment => segment.Bounds)]), BoxTree.Build([.. _source.Select(segment => segment.Bounds)]));
    }

    /// <summary>The point of the path whose distance differs most from the radius, and by how much; null when none differs by more than the
    /// tolerance.</summary>
    public (Point2D Place, double Distance, int Contour)? MaxDeviation()
    {
        var worst = default((Point2D, double Off, int)?);
        foreach (var loop in _loops)
        {
            for (var i = 0; i < loop.Segments.Count; i++)
            {
                foreach (var fraction in s_fractions)
                {
                    var place = loop.Segments[i].PointAt(fraction);
                    var off = Math.Abs(Nearest(_sourceBoxes, _source, place) - _options.Radius);
                    if (off > Math.Max(_options.Tolerance, worst?.Off ?? 0.0)) worst = (place, off, loop.Sources[i].Contour);
                }
            }
        }

        return worst;
    }

    /// <summary>The places of a drawn contour that the tool does not touch, one for each continuous part.</summary>
    /// <param name="contour">Index among the contours that were compensated together.</param>
    /// <param name="entityOf">Entity of a segment.</param>
    public IEnumerable<UncutPlace> UncutOf(int contour, Func<int, int> entityOf)
    {
        var places = Places(_drawn[contour].Segments).ToList();
        var first = places.FindIndex(place => place.Uncut <= _options.Tolerance);
        if (first < 0)
        {
            var (whole, uncut, segment) = places.MaxBy(place => place.Uncut);
            yield return new UncutPlace(whole, double.IsFinite(uncut) ? uncut : _options.ToolDiameterMm, entityOf(segment), IsWhole: true);
            yield break;
        }

        var worst = default((Point2D Place, double Uncut, int Segment)?);
        for (var i = 1; i <= places.Count; i++)
        {
            var place = places[(first + i) % places.Count];
            if (place.Uncut > (worst?.Uncut ?? _options.Tolerance)) worst = place;
            if (place.Uncut > _options.Tolerance || worst is not { } found) continue;
            yield return new UncutPlace(found.Place, found.Uncut, entityOf(found.Segment), IsWhole: false);
            worst = null;
        }
    }

    private IEnumerable<(Point2D Place, double Uncut, int Segment)> Places(IReadOnlyList<Segment> segments)
    {
        for (var i = 0; i < segments.Count; i++)
        {
            var steps = Math.Clamp((int)Math.Min(MaxSteps, segments[i].Length * StepsPerRadius / _options.Radius), MinSteps, MaxSteps);
            for (var step = 0; step < steps; step++)
            {
                var place = step == 0 ? segments[i].Start : segments[i].PointAt((double)step / steps);
                yield return (place, Nearest(_pathBoxes, _path, place) - _options.Radius, i);
            }
        }
    }

    private static double Nearest(BoxTree boxes, Segment[] segments, Point2D place)
    {
        boxes.Nearest(place, (item, from) => SegmentDistance.Measure(segments[item], from), double.PositiveInfinity, out var distance);
        return distance;
    }
}
