using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Largest distance of a span from the drawing, the length outside the drawing, and the segments near it, without stepping along it: a part is
/// complete when it cannot contain a larger deviation than the known one.</summary>
/// <remarks>Lines and arcs against lines and arcs have exact bounds (<see cref="FarthestDistance"/>), so that the work follows the number of joints under a
/// span and
/// not its length. For curves, a part is evaluated at three places when it is short and over one piece or two neighbours, where the distance is
/// smooth.</remarks>
internal sealed class SpanDeviation(Segment[] drawing, SegmentIndex index, DrawnCoverage coverage, TraceTolerances tolerances)
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
    /// <param name="extra">The length outside the drawing found so far.</param>
    public Result Measure(in TraceSpan span, double known, double extra)
    {
        _found = new Result(known, 0.0, 0.0);
        _undecided = Math.Max(tolerances.Count / 4.0, ExtraKnown * extra);
        coverage.Begin();
        Nearest(span.Path, 1.0, out _);
        Visit(span.Path, 0.0, 1.0, DeepestPart);
        return _found;
    }

    private void Visit(in Segment path, double from, double to, int depth)
    {
        var middle = (from + to) / 2.0;
        var length = path.Length * (to - from);
        var nearest = Nearest(path, middle, out var distance);
        if (nearest < 0)
        {
            _found = _found with { Extra = _found.Extra + length };
            return;
        }

        var most = distance + (length / 2.0);
        var isWorthBounding = most > NegligibleDeviation || most > _reach;
        if (isWorthBounding) most = Math.Min(most, drawing[nearest].IsFreeCurve ? FarthestOfCurve(path, from, to, distance) : FarthestDistance.FromDrawn(drawing[nearest], SegmentPart.Of(path, from, to)));
        var isBeside = distance > _reach && (distance - (length / 2.0) > _reach || !index.ComesNear(SegmentPart.Of(path, from, to), _reach));
        if (most <= NegligibleDeviation && (most <= _reach || isBeside))
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

    /// <summary>Also reports the segment found there.</summary>
    private int Nearest(in Segment path, double at, out double distance)
    {
        var nearest = index.NearEnoughTo(path.PointAt(at), Unremarkable, out distance);
        Offer(distance, at);
        if (distance <= _reach) coverage.Add(nearest, path);
        return nearest;
    }

    private void Offer(double distance, double at)
    {
        if (distance > _found.Largest) _found = _found with { Largest = distance, At = at };
    }

    private double FarthestOfCurve(in Segment path, double from, double to, double inMiddle)
    {
        if (to - from > ShortPart) return double.PositiveInfinity;
        var first = Nearest(path, from, out var atFirst);
        var last = Nearest(path, to, out var atLast);
        if (Math.Abs(first - last) > 1) return double.PositiveInfinity;
        return Math.Max(inMiddle, Math.Max(atFirst, atLast)) + Math.Abs(atFirst - (2.0 * inMiddle) + atLast);
    }

    /// <param name="Largest">Largest deviation, millimetres, at least the value known before.</param>
    /// <param name="At">Place as a fraction of the span; undefined when no larger deviation was found.</param>
    /// <param name="Extra">Length farther from the drawing than the coverage tolerance.</param>
    internal readonly record struct Result(double Largest, double At, double Extra);
}
