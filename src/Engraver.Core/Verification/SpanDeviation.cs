using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Largest distance of a span from the drawing, how much of it lies beside it, and which segments it is near, without walking along it: a part is done when it can hold nothing worse than what is known.</summary>
/// <remarks>Lines and arcs against lines and arcs have exact bounds (<see cref="FarthestOf"/>), so that the work follows the number of joints under a span and not its length.
/// Against curves a part is judged by three places once it is short and lies over one piece or two neighbours, on which the distance is smooth.</remarks>
internal sealed class SpanDeviation(Segment[] drawing, SegmentIndex index, DrawnCoverage coverage, TraceTolerances tolerances)
{
    private const double KnownPart = 0.002;

    /// <summary>Of the length beside the drawing so far: a shorter part is beside it, or not, by its middle.</summary>
    private const double ExtraKnown = 1e-5;
    private const double ShortPart = 1.0 / 8.0;
    private const int DeepestPart = 60;

    private readonly double _reach = tolerances.Coverage;
    private readonly double _resolution = tolerances.Count / 50.0;
    private readonly double _shortest = tolerances.Count / 4.0;
    private double _undecided;
    private Result _found;

    /// <param name="known">The largest distance found before: less need not be found exactly.</param>
    /// <param name="extra">And the length beside the drawing.</param>
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
        var isWorthBounding = most > Enough || most > _reach;
        if (isWorthBounding) most = Math.Min(most, drawing[nearest].IsFreeCurve ? FarthestOfCurve(path, from, to, distance) : FarthestOf.Drawn(drawing[nearest], SegmentPart.Of(path, from, to)));
        var isBeside = distance > _reach && (distance - (length / 2.0) > _reach || !index.ComesNear(SegmentPart.Of(path, from, to), _reach));
        if (most <= Enough && (most <= _reach || isBeside))
        {
            if (isBeside) _found = _found with { Extra = _found.Extra + length };
            return;
        }

        if (depth == 0 || (length <= _undecided && (length <= _shortest || most <= Enough)))
        {
            if (distance > _reach) _found = _found with { Extra = _found.Extra + length };
            return;
        }

        Visit(path, from, middle, depth - 1);
        Visit(path, middle, to, depth - 1);
    }

    /// <summary>A part that holds no more than this changes nothing worth telling.</summary>
    private double Enough => _found.Largest + Math.Max(_resolution, KnownPart * _found.Largest);

    /// <summary>A place no farther than this is neither beside the drawing nor the farthest yet; which segment is nearest to it does not matter.</summary>
    private double Unremarkable => Math.Min(_found.Largest, _reach);

    /// <summary>Tells what is found there as well.</summary>
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

    /// <param name="Largest">Millimetres, at least what was known before.</param>
    /// <param name="At">Where, as a fraction of the span; without meaning when nothing larger was found.</param>
    /// <param name="Extra">Length farther from the drawing than the coverage tolerance.</param>
    internal readonly record struct Result(double Largest, double At, double Extra);
}
