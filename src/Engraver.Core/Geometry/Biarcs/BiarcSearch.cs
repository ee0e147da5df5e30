namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Covers a smooth run with arcs, each pair (or single arc, where one is sufficient) as long as the tolerance allows.</summary>
internal sealed class BiarcSearch(SmoothRun run, double tolerance)
{
    /// <summary>Relative precision at which the bisection for the longest fit ends.</summary>
    private const double LengthKnown = 0.01;

    private const int SingleSteps = 20;

    /// <summary>After this number of lines in a row, rounding and not a cusp prevents arcs (a small curve far from the origin), and the search is
    /// abandoned.</summary>
    private const int MaxLines = 16;

    private const double SmallestStep = 1e-12;

    private readonly BiarcChoice _choice = new(run, tolerance);
    private readonly List<TangentArc> _arcs = [];
    private double _step = 1.0;

    /// <summary>The arcs and lines from the run's start to its end. Neighbours share point and direction, except where a line bridges a cusp.</summary>
    public IReadOnlyList<TangentArc> Cover()
    {
        var tangent = run.TangentAt(0.0);
        var lines = 0;
        for (var from = 0.0; from < run.End;)
        {
            var (to, pair) = LongestFrom(from, tangent);
            if (SingleFrom(from, tangent, pair is null ? from : to) is { } single)
            {
                to = single.To;
                _arcs.Add(single.Arc);
                tangent = single.Arc.EndTangent;
            }
            else
            {
                lines = pair is null ? lines + 1 : 0;
                if (lines > MaxLines) to = Math.Min(run.End, Math.Max(to, from + Math.ScaleB(SmallestStep, lines - MaxLines)));
                Add(from, to, pair);
                tangent = pair?.Second.EndTangent ?? run.TangentAt(to);
            }

            _step = Math.Max(to - from, double.Epsilon);
            from = to;
        }

        return _arcs;
    }

    private void Add(double from, double to, Biarc? pair)
    {
        if (pair is { } arcs)
        {
            _arcs.Add(arcs.First);
            _arcs.Add(arcs.Second);
        }
        else
        {
            _arcs.Add(TangentArc.Straight(run.PlaceAt(from), run.PlaceAt(to)));
        }
    }

    private (double To, Biarc? Pair) LongestFrom(double from, Vector2D tangent)
    {
        var good = from;
        Biarc? best = null;
        var bad = double.PositiveInfinity;
        for (var step = _step; good < run.End && double.IsPositiveInfinity(bad);)
        {
            var to = Math.Min(run.End, good + step);
            if (FitBetween(from, tangent, to) is { } pair) (good, best, step) = (to, pair, 2.0 * step);
            else bad = to;
        }

        while (bad - good > LengthKnown * (good - from) && !double.IsPositiveInfinity(bad))
        {
            var to = (good + bad) / 2.0;
            if (to <= good || to >= bad) break;
            if (FitBetween(from, tangent, to) is { } pair) (good, best) = (to, pair);
            else if (best is null && IsNegligible(from, to)) return (to, null);
            else bad = to;
        }

        return best is null ? (Math.Max(Math.Min(bad, run.End), Math.BitIncrement(from)), null) : (good, best);
    }

    private Biarc? FitBetween(double from, Vector2D tangent, double to) => _choice.Between(from, tangent, to, run.TangentAt(to));

    /// <summary>One arc instead of two, as far as it fits; null when it covers less than half of what two cover, or when two reach the run's end and it does
    /// not.</summary>
    private (double To, TangentArc Arc)? SingleFrom(double from, Vector2D tangent, double reach)
    {
        if (reach <= from) return null;
        if (reach >= run.End) return _choice.Single(from, tangent, run.End) is { } whole ? (run.End, whole) : null;
        for (var step = SingleSteps; step >= SingleSteps / 4; step--)
        {
            var (low, high) = (SinglePlace(from, reach, step - 1), SinglePlace(from, reach, step));
            if (high <= low || _choice.SingleBetween(from, tangent, low, high) is not { } single) continue;
            return single;
        }

        return null;
    }

    /// <summary>End places to try: evenly from a half to twice the reach of two arcs, each moved to a span's end near it (CAD writes circles as splines of four
    /// spans).</summary>
    private double SinglePlace(double from, double reach, int step)
    {
        var place = from + ((reach - from) * 2.0 * step / SingleSteps);
        var joint = Math.Round(place);
        return Math.Min(run.End, joint > from && Math.Abs(joint - place) <= (reach - from) / SingleSteps ? joint : place);
    }

    /// <summary>True when all control points are within half the tolerance of the start: a line is then near enough, whatever the shape of the curve.</summary>
    private bool IsNegligible(double from, double to)
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
