namespace Engraver.Tools.CrossChecks;

/// <summary>Splines by the textbook: de Boor for control points, a full linear system for fit points.</summary>
internal static class CrossCheckSplines
{
    private const int LargestSystem = 3000;

    /// <summary>The pieces of a spline; null when its data give no curve.</summary>
    public static List<CrossCheckPiece>? Read(CrossCheckRecord record)
    {
        var (controls, fits) = (Points(record, 10), Points(record, 11));
        return controls.Count > 0 ? OfControls(record, controls) : OfFitPoints(record, fits);
    }

    private static List<CrossCheckPoint> Points(CrossCheckRecord record, int code)
    {
        var points = new List<CrossCheckPoint>();
        foreach (var tag in record.Tags)
        {
            if (tag.Code == code) points.Add(new CrossCheckPoint(record.Number(tag), 0.0, 0.0));
            else if (points.Count > 0 && tag.Code == code + 10) points[^1] = points[^1] with { Y = record.Number(tag) };
            else if (points.Count > 0 && tag.Code == code + 20) points[^1] = points[^1] with { Z = record.Number(tag) };
        }

        return points;
    }

    private static List<CrossCheckPiece>? OfControls(CrossCheckRecord record, List<CrossCheckPoint> controls)
    {
        var degree = (int)record.Number(71, 3.0);
        if (degree < 1 || degree > 25 || controls.Count <= degree) return null;
        var (knots, weights) = (record.Numbers(40), record.Numbers(41));
        Climb(knots);
        var isTwoShort = knots.Length >= 2 * degree && knots.Length == controls.Count + degree - 1 && knots[degree - 1] <= knots[0] && knots[^1] <= knots[^degree];
        if (isTwoShort) knots = [knots[0], .. knots, knots[^1]]; // as OpenNURBS writes clamped ones
        var usable = knots.Length == controls.Count + degree + 1 && !knots.Zip(knots.Skip(1)).Any(pair => !(pair.First <= pair.Second)) && knots[degree] < knots[controls.Count];
        if (!usable) knots = [.. Enumerable.Range(0, controls.Count + degree + 1).Select(i => (double)Math.Clamp(i - degree, 0, controls.Count - degree))];
        if (weights.Length != controls.Count || !weights.All(weight => weight > 0.0)) weights = [.. controls.Select(_ => 1.0)];
        var pieces = new List<CrossCheckPiece>();
        for (var span = degree; span < controls.Count; span++)
        {
            var (k, from, to) = (span, knots[span], knots[span + 1]);
            if (from < to) pieces.Add(new CrossCheckPiece(t => DeBoor(degree, k, knots, weights, controls, from + (t * (to - from)))));
        }

        return pieces;
    }

    /// <summary>Raises a knot that is below the previous one by at most 1e-9 of their range: it was rounded.</summary>
    private static void Climb(double[] knots)
    {
        for (var i = 1; i < knots.Length; i++)
        {
            if (knots[i] < knots[i - 1] && knots[i - 1] - knots[i] <= 1e-9 * (knots[^1] - knots[0])) knots[i] = knots[i - 1];
        }
    }

    private static CrossCheckPoint DeBoor(int degree, int span, double[] knots, double[] weights, List<CrossCheckPoint> controls, double u)
    {
        var points = Enumerable.Range(span - degree, degree + 1).Select(i => weights[i] * controls[i]).ToArray();
        var shares = Enumerable.Range(span - degree, degree + 1).Select(i => weights[i]).ToArray();
        for (var level = 1; level <= degree; level++)
        {
            for (var j = degree; j >= level; j--)
            {
                var low = knots[j + span - degree];
                var a = (u - low) / (knots[j + 1 + span - level] - low);
                points[j] = ((1.0 - a) * points[j - 1]) + (a * points[j]);
                shares[j] = ((1.0 - a) * shares[j - 1]) + (a * shares[j]);
            }
        }

        return (1.0 / shares[degree]) * points[degree];
    }

    private static List<CrossCheckPiece>? OfFitPoints(CrossCheckRecord record, List<CrossCheckPoint> given)
    {
        if (given.Count < 2) return null;
        var closed = ((int)record.Number(70, 0.0) & 1) != 0;
        var points = given.Where((point, i) => i == 0 || point != given[i - 1]).ToList();
        while (closed && points.Count > 1 && points[^1] == points[0]) points.RemoveAt(points.Count - 1);
        closed &= points.Count > 2;
        if (closed) points.Add(points[0]);
        if (points.Count > LargestSystem) throw new CrossCheckException(Wording.Get("CrossCheckSplines.TooManyFitPoints"));
        if (points.Count < 2) return [];
        var h = Enumerable.Range(0, points.Count - 1).Select(i => points[i].To(points[i + 1])).ToArray();
        var slopes = Slopes(points, h, closed, Unit(record, 12), Unit(record, 13));
        var pieces = new List<CrossCheckPiece>();
        for (var i = 0; i + 1 < points.Count; i++)
        {
            var (a, b, ma, mb) = (points[i], points[i + 1], h[i] * slopes[i], h[i] * slopes[i + 1]);
            pieces.Add(new CrossCheckPiece(t => ((1 + (2 * t)) * (1 - t) * (1 - t) * a) + (t * (1 - t) * (1 - t) * ma) + (t * t * (3 - (2 * t)) * b) + (t * t * (t - 1) * mb)));
        }

        return pieces;
    }

    private static CrossCheckPoint? Unit(CrossCheckRecord record, int code)
    {
        var vector = new CrossCheckPoint(record.Number(code, 0.0), record.Number(code + 10, 0.0), record.Number(code + 20, 0.0));
        return vector.To(default) is > 0.0 and var length ? (1.0 / length) * vector : null;
    }

    /// <summary>The slopes at the fit points for which second derivatives are equal on both sides of inner points. At an end the second derivative is 0, or
    /// the slope is the given one; a closed spline has its ends joined like an inner point.</summary>
    private static CrossCheckPoint[] Slopes(List<CrossCheckPoint> points, double[] h, bool closed, CrossCheckPoint? start, CrossCheckPoint? end)
    {
        var n = points.Count;
        var (matrix, right) = (new double[n, n], new CrossCheckPoint[n]);
        for (var i = 0; i < n; i++)
        {
            var inner = i > 0 && i < n - 1;
            if (inner || (closed && i == 0)) Inner(i, inner ? i - 1 : n - 2, i);
            else if (closed) (matrix[i, i], matrix[i, 0]) = (1.0, -1.0);
            else if ((i == 0 ? start : end) is { } slope) (matrix[i, i], right[i]) = (1.0, slope);
            else Natural(i, i == 0 ? 1 : n - 2, Math.Min(i, n - 2));
        }

        return Solve(matrix, right);

        void Inner(int row, int before, int after)
        {
            matrix[row, before] += 1.0 / h[before];
            matrix[row, row] += 2.0 * ((1.0 / h[before]) + (1.0 / h[after]));
            matrix[row, after + 1] += 1.0 / h[after];
            right[row] = (3.0 / (h[before] * h[before]) * (points[before + 1] - points[before])) + (3.0 / (h[after] * h[after]) * (points[after + 1] - points[after]));
        }

        void Natural(int row, int other, int step)
        {
            (matrix[row, row], matrix[row, other]) = (2.0, 1.0);
            right[row] = 3.0 / h[step] * (points[step + 1] - points[step]);
        }
    }

    private static CrossCheckPoint[] Solve(double[,] matrix, CrossCheckPoint[] right)
    {
        var n = right.Length;
        for (var column = 0; column < n; column++)
        {
            var pivot = Enumerable.Range(column, n - column).MaxBy(row => Math.Abs(matrix[row, column]));
            for (var k = 0; k < n; k++) (matrix[column, k], matrix[pivot, k]) = (matrix[pivot, k], matrix[column, k]);
            (right[column], right[pivot]) = (right[pivot], right[column]);
            for (var row = 0; row < n; row++)
            {
                var factor = row == column ? 0.0 : matrix[row, column] / matrix[column, column];
                if (factor == 0.0) continue;
                for (var k = column; k < n; k++) matrix[row, k] -= factor * matrix[column, k];
                right[row] -= factor * right[column];
            }
        }

        return [.. right.Select((value, i) => (1.0 / matrix[i, i]) * value)];
    }
}
