using Engraver.Core.Geometry;
using Engraver.Core.Verification.Corners;

namespace Engraver.Core.Verification;

/// <summary>Largest distance of a span from the drawing, the length outside the drawing, and the segments near it, without stepping along it: a part is
/// complete when it cannot contain a larger deviation than the known one.</summary>
/// <remarks>Lines and arcs against lines and arcs have exact bounds (<see cref="FarthestDistance"/>), so that the work follows the number of joints under a
/// span and
/// not its length. For curves, a part is evaluated at three places when it is short and over one piece or two neighbours, where the distance is
/// smooth.</remarks>
internal sealed class SpanDeviation(Segment[] drawing, SegmentIndex index, DrawnCorners corners, DrawnCoverage coverage, TraceTolerances tolerances)
{
    private const double KnownPart = 0.002;

    /// <summary>Fraction of the length outside the drawing so far: a shorter part is classified by its middle.</summary>
    private const double ExtraKnown = 1e-5;
    private const double ShortPart = 1.0 / 8.0;
    private const int DeepestPart = 60;

    private readonly double _reach = tolerances.Coverage;
    private readonly double _resolution = tolerances.Count / 50.0;
    private readonly double _shortest = tolerances.Count / 4.0;
    private double _undecided;
    private Result _found;

    /// <param name="known">The largest distance found so far: smaller distances need not be exact.</param>
    /// <param name="knownAtCorner">The same where corners are rounded.</param>
    /// <param name="extra">The length outside the drawing found so far.</param>
    public Result Measure(in TraceSpan span, double known, double knownAtCorner, double extra)
    {
        _found = new Result(known, 0.0, 0.0, knownAtCorner);
        _undecided = Math.Max(tolerances.Count / 4.0, ExtraKnown * extra);
        coverage.Begin();
        Evaluate(span.Path, 1.0);
        Visit(span.Path, 0.0, 1.0, DeepestPart);
        return _found;
    }

    private void Visit(in Segment path, double from, double to, int depth)
    {
        var middle = (from + to) / 2.0;
        var length = path.Length * (to - from);
        var found = Evaluate(path, middle);
        var (nearest, distance) = (found.Nearest, found.Deviation);
        if (nearest < 0)
        {
            _found = _found with { Extra = _found.Extra + length };
            return;
        }

        var fromDrawing = found.Distance + (length / 2.0);
        var isWorthBounding = fromDrawing > NegligibleDeviation || fromDrawing > _reach;
        if (isWorthBounding) fromDrawing = Math.Min(fromDrawing, drawing[nearest].IsFreeCurve ? FarthestOfCurve(path, from, to, found.Distance) : FarthestDistance.FromDrawn(drawing[nearest], SegmentPart.Of(path, from, to)));
        var most = Math.Min(fromDrawing, distance + (length / 2.0));
        if (most > NegligibleDeviation && found.Corner >= 0) most = Math.Min(most, Math.Max(tolerances.Count, corners[found.Corner].FarthestOf(SegmentPart.Of(path, from, to))));
        var isBeside = distance > _reach && (distance - (length / 2.0) > _reach || !ComesNear(SegmentPart.Of(path, from, to)));
        if (most <= NegligibleDeviation && (most <= _reach || isBeside) && (fromDrawing <= NegligibleDeviation || fromDrawing <= NegligibleAtCorner))
        {
            if (isBeside) _found = _found with { Extra = _found.Extra + length };
            return;
        }

        if (depth == 0 || (length <= _undecided && (length <= _shortest || most <= NegligibleDeviation)))
        {
            if (distance > _reach) _found = _found with { Extra = _found.Extra + length };
            return;
        }

        Visit(path, from, middle, depth - 1);
        Visit(path, middle, to, depth - 1);
    }

    /// <summary>A part with a deviation up to this value does not change the result significantly.</summary>
    private double NegligibleDeviation => _found.Largest + Math.Max(_resolution, KnownPart * _found.Largest);

    /// <summary>A place within this distance is neither outside the drawing nor the farthest so far; its nearest segment is irrelevant.</summary>
    private double Unremarkable => Math.Min(_found.Largest, _reach);

    /// <summary>Compares a place with the drawing; also reports the segment found there.</summary>
    private SpanPlace Evaluate(in Segment path, double at)
    {
        var place = path.PointAt(at);
        var nearest = index.NearEnoughTo(place, Unremarkable, out var distance);
        var (corner, deviation) = (-1, distance);
        if (distance > Unremarkable) corner = corners.NearestTo(place, distance, Unremarkable, out deviation);
        if (deviation > _found.Largest) _found = _found with { Largest = deviation, At = at };
        if (corner >= 0 && deviation <= tolerances.Deviation && distance > _found.LargestAtCorner) _found = _found with { LargestAtCorner = distance };
        if (distance <= _reach) coverage.Add(nearest, path);
        coverage.Round(nearest, path);
        return new SpanPlace(nearest, distance, deviation, corner);
    }

    /// <summary>The same for the deviation at a corner, which decides nothing.</summary>
    private double NegligibleAtCorner => _found.LargestAtCorner + Math.Max(tolerances.Count / 10.0, KnownPart * _found.LargestAtCorner);

    private bool ComesNear(in Segment part) => index.ComesNear(part, _reach) || corners.ComesNear(part, _reach);

    private double FarthestOfCurve(in Segment path, double from, double to, double inMiddle)
    {
        if (to - from > ShortPart) return double.PositiveInfinity;
        var ((first, atFirst, _, _), (last, atLast, _, _)) = (Evaluate(path, from), Evaluate(path, to));
        if (Math.Abs(first - last) > 1) return double.PositiveInfinity;
        return Math.Max(inMiddle, Math.Max(atFirst, atLast)) + Math.Abs(atFirst - (2.0 * inMiddle) + atLast);
    }

    /// <param name="Largest">Largest deviation, millimetres, at least the value known before.</param>
    /// <param name="At">Place as a fraction of the span; undefined when no larger deviation was found.</param>
    /// <param name="Extra">Length farther from the drawing than the coverage tolerance.</param>
    /// <param name="LargestAtCorner">Largest distance from the drawing in the regions of its corners, at least the value known before.</param>
    internal readonly record struct Result(double Largest, double At, double Extra, double LargestAtCorner);

    /// <summary>A place of a span.</summary>
    /// <param name="Nearest">The nearest segment, or one that is near enough; -1 for none.</param>
    /// <param name="Distance">Its distance.</param>
    /// <param name="Deviation">The same, or the distance from the region of a corner if that is smaller.</param>
    /// <param name="Corner">That corner; -1 for none.</param>
    private readonly record struct SpanPlace(int Nearest, double Distance, double Deviation, int Corner);
}
