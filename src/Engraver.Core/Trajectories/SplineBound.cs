using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>A proven upper bound of the distance between a spline and its chain, in both directions: both curves are traversed together, and no two points
/// passed at the same parameter are farther apart (a bound of the Frechet distance).</summary>
/// <remarks>
/// Each cubic is cut into parts and each part is paired with a part of the chain, in sequence without gaps. Both are Bezier curves on the same parameter, the
/// chain's with weights; their difference is also a rational Bezier curve, with the control points D(k) = sum of C(3,i) C(d,j) w(j) (S(i) - P(j)) over sum of
/// C(3,i) C(d,j) w(j), i + j = k, which encloses it: the largest |D(k)| is the bound. The cuts between the pairs determine how tight the bound is, never
/// whether it is valid; samples are not used. Rounding has a separate allowance.
/// </remarks>
internal static class SplineBound
{
    /// <summary>Parts are halved until they add at most this fraction to the lower bound of the distance.</summary>
    private const double Slack = 0.004;

    private const int MaxHalvings = 9;

    /// <summary>Distances below this are not refined further, millimetres.</summary>
    private const double MinDistance = 1e-9;

    /// <summary>Rounding of all steps as a fraction of the coordinates, generous.</summary>
    private const double Rounding = 64.0 * 2.220446049250313e-16;

    /// <summary>Length of the chain, as a fraction of its total length, that rounding may leave out between two pairs.</summary>
    private const double SkippedLength = 1e-12;

    /// <summary>The bound in millimetres; infinite when the pairing fails.</summary>
    /// <param name="spline">One cubic for each step of <paramref name="knots"/>.</param>
    /// <param name="chain">The chain that it approximates.</param>
    /// <param name="knots">Increasing lengths along the chain of the visited points; for a closed chain the last is the first plus the chain length. The first
    /// and the last of an open chain are its ends.</param>
    /// <param name="within">Above this value the search stops: the result is then some larger number.</param>
    public static double Measure(CatmullRomSpline spline, SmoothChain chain, IReadOnlyList<double> knots, double within = double.PositiveInfinity) =>
        Measure(spline.Count, i => spline[i], chain, knots, within);

    /// <summary>The same for any curve of cubics.</summary>
    public static double Measure(int count, Func<int, Cubic> cubics, SmoothChain chain, IReadOnlyList<double> knots, double within)
    {
        var search = new Pairing(chain, within) { Sure = SampledDistance.Of(count, cubics, chain, knots, steps: 8) };
        for (var i = 0; i < count && search.Bound <= within; i++) search.Examine(cubics(i), knots[i], knots[i + 1]);
        var far = Enumerable.Range(0, count).Max(i => Math.Abs(cubics(i).A.X) + Math.Abs(cubics(i).A.Y));
        return search.Bound + (Rounding * far) + (SkippedLength * chain.Length);
    }

    private sealed class Pairing(SmoothChain chain, double within)
    {
        /// <summary>A distance that is reached: it only shows where halving would not help.</summary>
        public double Sure { get; init; }

        public double Bound { get; private set; }

        /// <summary>Pairs a cubic with the chain between two lengths: cut wherever a piece of the chain ends.</summary>
        public void Examine(Cubic cubic, double from, double to)
        {
            var rest = cubic;
            while (true)
            {
                var start = chain.Wrapped(from);
                var piece = chain.Pieces[chain.PieceAt(start)];
                var left = to - from;
                if (start + left <= piece.End + (1e-12 * chain.Length) || !IsMore(piece))
                {
                    Pair(rest, piece, piece.FractionAt(start), piece.FractionAt(start + left), MaxHalvings);
                    return;
                }

                var (first, second) = rest.Split(PerpendicularFoot(rest, piece));
                Pair(first, piece, piece.FractionAt(start), 1.0, MaxHalvings);
                from += Math.Max(piece.End - start, 0.0);
                if (chain.Wrapped(from) is var next && chain.PieceAt(next) == chain.PieceAt(start)) from += 1e-13 * chain.Length;
                rest = second;
            }
        }

        private bool IsMore(ChainPiece piece) => chain.Closed || piece.End < chain.Length;

        /// <summary>The parameter at which the cubic passes the end of a piece.</summary>
        private static double PerpendicularFoot(in Cubic cubic, ChainPiece piece)
        {
            var end = piece.At(1.0);
            var (low, high) = (0.0, 1.0);
            for (var i = 0; i < 40; i++)
            {
                var middle = (low + high) / 2.0;
                if ((cubic.At(middle) - piece.EndPoint).Dot(end.Tangent) < 0.0) low = middle;
                else high = middle;
            }

            return (low + high) / 2.0;
        }

        private void Pair(in Cubic cubic, ChainPiece piece, double from, double to, int halvings)
        {
            var bound = piece.Part(from, to) is { } part ? Apart(cubic, part) : double.PositiveInfinity;
            if (piece.IsLine) bound = Math.Min(bound, BesideLine(cubic, piece.Segment.PointAt(from), piece.Segment.PointAt(to)));
            if (bound <= Math.Max(Math.Max(Bound, MinDistance), Sure * (1.0 + Slack)) || (halvings == 0 && double.IsFinite(bound)))
            {
                Bound = Math.Max(Bound, bound);
                return;
            }

            if (halvings < -8 || Bound > within)
            {
                Bound = double.PositiveInfinity;
                return;
            }

            var (first, second) = cubic.Split(0.5);
            var middle = Math.Clamp(piece.Foot(first.D, (from + to) / 2.0), from, to);
            Pair(first, piece, from, middle, halvings - 1);
            Pair(second, piece, middle, to, halvings - 1);
        }

        /// <summary>The same for a line, independent of the speed of the cubic along it: a cubic whose control points advance along the line also advances, so
        /// that each of its points can be paired with its projection onto the line, and the ends with the ends.</summary>
        /// <returns>Infinite when the control points do not advance.</returns>
        private static double BesideLine(in Cubic cubic, Point2D start, Point2D end)
        {
            var length = start.DistanceTo(end);
            if (!(length > 0.0)) return double.PositiveInfinity;
            var way = (end - start) * (1.0 / length);
            var (a, b, c, d) = (way.Dot(cubic.A - start), way.Dot(cubic.B - start), way.Dot(cubic.C - start), way.Dot(cubic.D - start));
            if (!(a <= b && b <= c && c <= d && a < d)) return double.PositiveInfinity;
            var across = Math.Max(Math.Max(Math.Abs(way.Cross(cubic.A - start)), Math.Abs(way.Cross(cubic.B - start))), Math.Max(Math.Abs(way.Cross(cubic.C - start)), Math.Abs(way.Cross(cubic.D - start))));
            return double.Hypot(across, Math.Max(Math.Abs(a), Math.Abs(d - length)));
        }

        /// <summary>Largest control point of the difference.</summary>
        private static double Apart(in Cubic cubic, BezierSpan part)
        {
            var degree = part.Degree;
            ReadOnlySpan<Point2D> controls = [cubic.A, cubic.B, cubic.C, cubic.D];
            var (ours, theirs, largest) = (Bernstein.Binomials[3], Bernstein.Binomials[degree], 0.0);
            for (var k = 0; k <= degree + 3; k++)
            {
                var (x, y, weights) = (0.0, 0.0, 0.0);
                for (var i = Math.Max(0, k - degree); i <= Math.Min(3, k); i++)
                {
                    var (weight, control) = (ours[i] * theirs[k - i] * part.Weight(k - i), part.Control(k - i));
                    x += weight * (controls[i].X - control.X);
                    y += weight * (controls[i].Y - control.Y);
                    weights += weight;
                }

                largest = Math.Max(largest, double.Hypot(x, y) / weights);
            }

            return largest;
        }
    }
}
