namespace Engraver.Core.Geometry;

/// <summary>Covers a smooth run with biarcs, each as long as the tolerance allows.</summary>
internal sealed class BiarcSearch(SmoothRun run, double tolerance)
{
    /// <summary>The bisection for the longest fit ends when it knows the length to this part.</summary>
    private const double LengthKnown = 0.01;

    private const int JointSteps = 60;
    private double _step = 1.0;

    public void AppendTo(ArcChain chain)
    {
        for (var from = 0.0; from < run.End;)
        {
            var (to, biarc) = LongestFrom(from);
            if (biarc is { } pair)
            {
                chain.Add(pair.First);
                chain.Add(pair.Second);
            }
            else
            {
                chain.AddLine(run.PlaceAt(from), run.PlaceAt(to));
            }

            _step = Math.Max(to - from, double.Epsilon);
            from = to;
        }
    }

    private (double To, Biarc? Pair) LongestFrom(double from)
    {
        var good = from;
        Biarc? best = null;
        var bad = double.PositiveInfinity;
        for (var step = _step; good < run.End && double.IsPositiveInfinity(bad);)
        {
            var to = Math.Min(run.End, good + step);
            if (FitBetween(from, to) is { } pair) (good, best, step) = (to, pair, 2.0 * step);
            else bad = to;
        }

        while (bad - good > LengthKnown * (good - from) && !double.IsPositiveInfinity(bad))
        {
            var to = (good + bad) / 2.0;
            if (to <= good || to >= bad) break;
            if (FitBetween(from, to) is { } pair) (good, best) = (to, pair);
            else if (best is null && IsSpeck(from, to)) return (to, null);
            else bad = to;
        }

        return best is null ? (Math.Max(Math.Min(bad, run.End), Math.BitIncrement(from)), null) : (good, best);
    }

    private Biarc? FitBetween(double from, double to)
    {
        var (start, end) = (run.PlaceAt(from), run.PlaceAt(to));
        if (Biarc.Between(start, run.TangentAt(from), end, run.TangentAt(to)) is not { } pair) return null;
        if (JointBetween(from, to, pair.First.End, pair.First.EndTangent) is not { } joint) return null;
        return IsWithin(from, joint, pair.First) && IsWithin(joint, to, pair.Second) ? pair : null;
    }

    /// <summary>Where the curve crosses the normal through the joint (false position, Illinois); null when it does not get from one side to the other.</summary>
    private double? JointBetween(double from, double to, Point2D joint, Vector2D tangent)
    {
        var (low, high) = (from, to);
        var (atLow, atHigh) = ((run.PlaceAt(low) - joint).Dot(tangent), (run.PlaceAt(high) - joint).Dot(tangent));
        if (!(atLow < 0.0) || !(atHigh > 0.0)) return null;
        var near = tolerance * ArcDeviation.EndShare / 4.0;
        var side = 0;
        for (var step = 0; step < JointSteps; step++)
        {
            var middle = step % 8 == 7 ? (low + high) / 2.0 : low + ((high - low) * (atLow / (atLow - atHigh)));
            var at = (run.PlaceAt(middle) - joint).Dot(tangent);
            if (Math.Abs(at) <= near) return middle;
            if (at < 0.0) (low, atLow, atHigh, side) = (middle, at, side < 0 ? atHigh / 2.0 : atHigh, -1);
            else (high, atHigh, atLow, side) = (middle, at, side > 0 ? atLow / 2.0 : atLow, 1);
        }

        return null;
    }

    private bool IsWithin(double from, double to, in TangentArc arc)
    {
        foreach (var piece in run.Between(from, to))
        {
            if (!ArcDeviation.IsWithin(piece, arc, tolerance)) return false;
        }

        return true;
    }

    /// <summary>Control points all within half the tolerance of the start: a line is near enough whatever the curve does.</summary>
    private bool IsSpeck(double from, double to)
    {
        var start = run.PlaceAt(from);
        foreach (var piece in run.Between(from, to))
        {
            for (var i = 0; i <= piece.Degree; i++)
            {
                if (!piece.Control(i).IsNear(start, tolerance / 2.0)) return false;
            }
        }

        return true;
    }
}
