namespace Engraver.Core.Geometry;

/// <summary>Shortest distance from a point to a span of any shape: control points may coincide, reverse, or form a cusp.</summary>
/// <remarks>
/// With N the vector from the point to the span times the weight w, the squared distance is N.N / w^2, and its slope has the sign of (N.N)' w - 2 N.N w'. Both
/// are polynomials whose Bernstein coefficients bound them: where no coefficient of N.N - d^2 w^2 is below zero, nothing is nearer than d; where the slope
/// changes its sign once, there is one nearest point, and Newton's steps between two parameters on either side find it. Parts that neither test decides are
/// halved. No test checks whether a derivative is zero.
/// </remarks>
internal static class SpanDistance
{
    private const int MaxHalvings = 48;

    /// <summary>Maximum number of parts in one query, for the case that rounding leaves halves undecided.</summary>
    private const int MaxParts = 2000;

    private const int MaxSteps = 60;

    private const double ParameterKnown = 1e-14;

    /// <summary>Relative precision of the distance: points nearer by less than this are not searched for.</summary>
    private const double DistanceKnown = 1e-12;

    /// <summary>Rounding error as a part of the point's coordinates.</summary>
    private const double Rounding = 4e-16;

    /// <summary>The distance, exact within rounding, or <paramref name="bound"/> when no point of the span is nearer than that.</summary>
    public static double Measure(BezierSpan span, Point2D place, double bound = double.PositiveInfinity)
    {
        var count = span.Degree + 1;
        Span<double> x = stackalloc double[count];
        Span<double> y = stackalloc double[count];
        Span<double> w = stackalloc double[count];
        for (var i = 0; i < count; i++)
        {
            var weight = span.Weight(i);
            (x[i], y[i], w[i]) = (span.Homogeneous[i * BezierSpan.Stride] - (place.X * weight), span.Homogeneous[(i * BezierSpan.Stride) + 1] - (place.Y * weight), weight);
        }

        var search = new SpanSearch { Best = bound, Noise = Rounding * (Math.Abs(place.X) + Math.Abs(place.Y)), Parts = MaxParts, IsRational = w.ContainsAnyExcept(w[0]) };
        search.Take(x[0], y[0], w[0]);
        search.Take(x[^1], y[^1], w[^1]);
        search.Examine(x, y, w, MaxHalvings);
        return search.Best;
    }

    private struct SpanSearch
    {
        public double Best;
        public double Noise;
        public int Parts;
        public bool IsRational;

        public void Take(double x, double y, double weight) => Best = Math.Min(Best, double.Hypot(x, y) / weight);

        /// <summary>Searches a part for points nearer than the best so far; its ends have been measured.</summary>
        public void Examine(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> w, int halvings)
        {
            var least = Best - (DistanceKnown * Best) - Noise;
            if (!(least > 0.0) || --Parts < 0) return;
            var degree = x.Length - 1;
            Span<double> squared = stackalloc double[(2 * degree) + 1];
            Span<double> weight = stackalloc double[degree + 1];
            Scale(w, weight);
            SquaredDistance(x, y, squared);
            if (CannotBeNearer(squared, weight, least)) return;
            Span<double> slope = stackalloc double[IsRational ? 3 * degree : 2 * degree];
            Slope(squared, weight, slope);
            var changes = Bernstein.SignChanges(slope, out var first);
            if (changes == 0 || (changes == 1 && first > 0)) return; // nearest at an end
            if (changes == 1) TakeFoot(x, y, w);
            else if (halvings > 0) Halve(x, y, w, halvings - 1);
        }

        private static void Scale(ReadOnlySpan<double> plain, Span<double> scaled)
        {
            var binomials = Bernstein.Binomials[plain.Length - 1];
            for (var i = 0; i < plain.Length; i++) scaled[i] = binomials[i] * plain[i];
        }

        private static void SquaredDistance(ReadOnlySpan<double> x, ReadOnlySpan<double> y, Span<double> squared)
        {
            Span<double> scaled = stackalloc double[x.Length];
            Scale(x, scaled);
            Bernstein.Multiply(scaled, scaled, squared);
            Scale(y, scaled);
            Bernstein.AddProduct(scaled, scaled, 1.0, squared);
        }

        private static bool CannotBeNearer(ReadOnlySpan<double> squared, ReadOnlySpan<double> weight, double least)
        {
            Span<double> excess = stackalloc double[squared.Length];
            squared.CopyTo(excess);
            Bernstein.AddProduct(weight, weight, -least * least, excess);
            foreach (var coefficient in excess)
            {
                if (!(coefficient >= 0.0)) return false;
            }

            return true;
        }

        private readonly void Slope(ReadOnlySpan<double> squared, ReadOnlySpan<double> weight, Span<double> slope)
        {
            Span<double> derivative = stackalloc double[squared.Length - 1];
            Bernstein.Differentiate(squared, derivative);
            if (!IsRational)
            {
                derivative.CopyTo(slope);
                return;
            }

            Bernstein.Multiply(derivative, weight, slope);
            Span<double> change = stackalloc double[weight.Length - 1];
            Bernstein.Differentiate(weight, change);
            Bernstein.AddProduct(squared, change, -2.0, slope);
        }

        /// <summary>Newton's steps (Gauss's form) to the one nearest point, between a parameter before it and one after it; halves the interval where the steps
        /// do not converge.</summary>
        private void TakeFoot(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> w)
        {
            var (low, high, parameter, before) = (0.0, 1.0, 0.5, double.PositiveInfinity);
            for (var step = 0; step < MaxSteps; step++)
            {
                var (ahead, speed) = At(x, y, w, parameter);
                if (ahead == 0.0) return;
                if (ahead > 0.0) low = parameter;
                else high = parameter;
                var next = parameter + (ahead / speed);
                if (high - low <= ParameterKnown || Math.Abs(next - parameter) <= ParameterKnown) return;
                if (!(next > low && next < high) || Math.Abs(ahead) > before / 2.0) next = (low + high) / 2.0;
                (parameter, before) = (next, Math.Abs(ahead));
            }
        }

        /// <summary>Measures the point at a parameter (de Casteljau). Returns the scalar product of the vector to the point with the derivative there, and the
        /// derivative's square.</summary>
        private (double Ahead, double Speed) At(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> w, double parameter)
        {
            var (px, dx) = Evaluate(x, parameter);
            var (py, dy) = Evaluate(y, parameter);
            var (weight, change) = IsRational ? Evaluate(w, parameter) : (w[0], 0.0);
            Take(px, py, weight);
            (px, py) = (px / weight, py / weight);
            (dx, dy) = ((dx - (px * change)) / weight, (dy - (py * change)) / weight);
            return (-((px * dx) + (py * dy)), (dx * dx) + (dy * dy));
        }

        private static (double Value, double Derivative) Evaluate(ReadOnlySpan<double> points, double parameter)
        {
            Span<double> work = stackalloc double[points.Length];
            points.CopyTo(work);
            for (var count = points.Length - 1; count > 1; count--)
            {
                for (var i = 0; i < count; i++) work[i] += parameter * (work[i + 1] - work[i]);
            }

            var slope = work[1] - work[0];
            return (work[0] + (parameter * slope), (points.Length - 1) * slope);
        }

        private void Halve(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> w, int halvings)
        {
            var count = x.Length;
            Span<double> halves = stackalloc double[6 * count];
            Halve(x, halves[..count], halves[(3 * count)..(4 * count)]);
            Halve(y, halves[count..(2 * count)], halves[(4 * count)..(5 * count)]);
            Halve(w, halves[(2 * count)..(3 * count)], halves[(5 * count)..]);
            Take(halves[3 * count], halves[4 * count], halves[5 * count]);
            Examine(halves[..count], halves[count..(2 * count)], halves[(2 * count)..(3 * count)], halvings);
            Examine(halves[(3 * count)..(4 * count)], halves[(4 * count)..(5 * count)], halves[(5 * count)..], halvings);
        }

        private static void Halve(ReadOnlySpan<double> points, Span<double> first, Span<double> second)
        {
            points.CopyTo(second);
            for (var i = 0; i < points.Length; i++)
            {
                first[i] = second[0];
                for (var j = 0; j < points.Length - 1 - i; j++) second[j] = (second[j] + second[j + 1]) / 2.0;
            }
        }
    }
}
