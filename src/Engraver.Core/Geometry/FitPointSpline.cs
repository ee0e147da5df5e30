namespace Engraver.Core.Geometry;

/// <summary>The cubic spline through given points, twice continuously differentiable, with knots at chord lengths, as CAD programs draw a spline that is stored
/// with fit points only.</summary>
public static class FitPointSpline
{
    /// <param name="points">At least two, no two neighbours equal; closed: the first is not repeated at the end.</param>
    /// <param name="startTangent">Direction at the start; null for a natural end (no curvature). Not used when closed.</param>
    /// <param name="endTangent">Direction of travel at the end.</param>
    /// <param name="closed">True for a smooth return to the first point.</param>
    public static RationalCurve Through(IReadOnlyList<Vector3D> points, Vector3D? startTangent, Vector3D? endTangent, bool closed)
    {
        var count = closed ? points.Count : points.Count - 1;
        var steps = new Vector3D[count];
        for (var i = 0; i < count; i++) steps[i] = points[(i + 1) % points.Count] - points[i];
        var slopes = closed ? ClosedSlopes(steps) : OpenSlopes(steps, startTangent, endTangent);
        var spans = new BezierSpan[count];
        for (var i = 0; i < count; i++) spans[i] = Span(points[i], slopes[i], slopes[(i + 1) % slopes.Length], points[(i + 1) % points.Count], steps[i].Length / 3.0);
        return new RationalCurve(SegmentKind.Spline, spans);
    }

    private static BezierSpan Span(Vector3D start, Vector3D slope, Vector3D endSlope, Vector3D end, double third)
    {
        var (second, beforeLast) = (start + (slope * third), end - (endSlope * third));
        return new BezierSpan([start.X, start.Y, start.Z, 1.0, second.X, second.Y, second.Z, 1.0, beforeLast.X, beforeLast.Y, beforeLast.Z, 1.0, end.X, end.Y, end.Z, 1.0]);
    }

    private static Vector3D[] OpenSlopes(Vector3D[] steps, Vector3D? startTangent, Vector3D? endTangent)
    {
        var rows = Rows.Inner(steps, steps.Length + 1, closed: false);
        rows.SetNatural(0, steps[0]);
        rows.SetNatural(steps.Length, steps[^1]);
        if (startTangent is { } start && start.Length > 0.0) rows.SetGiven(0, start * (1.0 / start.Length));
        if (endTangent is { } end && end.Length > 0.0) rows.SetGiven(steps.Length, end * (1.0 / end.Length));
        return rows.Solve(rows.Right);
    }

    /// <summary>Solves the cyclic system (Sherman and Morrison): a tridiagonal system and a correction for its two corner elements.</summary>
    private static Vector3D[] ClosedSlopes(Vector3D[] steps)
    {
        var n = steps.Length;
        if (n < 3) return OpenSlopes(steps, null, null)[..n];
        var rows = Rows.Inner(steps, n, closed: true);
        var corner = 1.0 / steps[^1].Length;
        var gamma = -rows.Middle[0];
        rows.Middle[0] -= gamma;
        rows.Middle[n - 1] -= corner * corner / gamma;
        var direct = rows.Solve(rows.Right);
        var bend = new Vector3D[n];
        (bend[0], bend[n - 1]) = (new Vector3D(gamma, 0.0, 0.0), new Vector3D(corner, 0.0, 0.0));
        var correction = rows.Solve(bend);
        var share = 1.0 / (1.0 + correction[0].X + (corner / gamma * correction[n - 1].X));
        var excess = (direct[0] + (direct[n - 1] * (corner / gamma))) * share;
        for (var i = 0; i < n; i++) direct[i] -= excess * correction[i].X;
        return direct;
    }

    /// <summary>The symmetric rows m(i-1)/h(i-1) + 2 (1/h(i-1) + 1/h(i)) m(i) + m(i+1)/h(i) = 3 (s(i-1)/h(i-1)^2 + s(i)/h(i)^2) for the slopes m.</summary>
    private sealed class Rows(int count)
    {
        public double[] Middle { get; } = new double[count];

        public double[] Beside { get; } = new double[count];

        public Vector3D[] Right { get; } = new Vector3D[count];

        public static Rows Inner(Vector3D[] steps, int count, bool closed)
        {
            var rows = new Rows(count);
            for (var i = 0; i < count - 1; i++) rows.Beside[i] = 1.0 / steps[i].Length;
            for (var i = closed ? 0 : 1; i < (closed ? count : count - 1); i++)
            {
                var (before, after) = (steps[(i + steps.Length - 1) % steps.Length], steps[i]);
                rows.Middle[i] = 2.0 * ((1.0 / before.Length) + (1.0 / after.Length));
                rows.Right[i] = ((before * (1.0 / before.Dot(before))) + (after * (1.0 / after.Dot(after)))) * 3.0;
            }

            return rows;
        }

        /// <summary>A row for zero curvature: 2 m0 + m1 = 3 s0/h0, divided by h so that the matrix remains symmetric.</summary>
        public void SetNatural(int row, Vector3D step)
        {
            Middle[row] = 2.0 / step.Length;
            Right[row] = step * (3.0 / step.Dot(step));
        }

        /// <summary>A row for a given slope; the neighbour's term with it moves to the right side.</summary>
        public void SetGiven(int row, Vector3D slope)
        {
            var (neighbour, beside) = row == 0 ? (1, 0) : (row - 1, row - 1);
            Right[neighbour] -= slope * Beside[beside];
            Beside[beside] = 0.0;
            Middle[row] = 1.0;
            Right[row] = slope;
        }

        public Vector3D[] Solve(Vector3D[] right)
        {
            var (diagonal, result) = ((double[])Middle.Clone(), (Vector3D[])right.Clone());
            for (var i = 1; i < count; i++)
            {
                var factor = Beside[i - 1] / diagonal[i - 1];
                diagonal[i] -= factor * Beside[i - 1];
                result[i] -= result[i - 1] * factor;
            }

            result[count - 1] *= 1.0 / diagonal[count - 1];
            for (var i = count - 2; i >= 0; i--) result[i] = (result[i] - (result[i + 1] * Beside[i])) * (1.0 / diagonal[i]);
            return result;
        }
    }
}
