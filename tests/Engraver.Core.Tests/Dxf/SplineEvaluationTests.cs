using Engraver.Core.Drawings;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Splines of every degree, clamped or not, with repeated knots and weights, compared with the recursion of Cox and de Boor as published.</summary>
public class SplineEvaluationTests
{
    [Fact]
    public void Places_and_heights_are_those_of_the_basis_functions()
    {
        for (var seed = 1; seed <= 300; seed++)
        {
            var spline = Spline.Random(new Random(seed));
            var drawing = DxfReading.Entities(spline.Pairs());
            Assert.Empty(drawing.Diagnostics);
            var curve = Assert.Single(drawing.Curves);

            Assert.Equal(spline.Spans.Count, curve.Spans.Length);
            for (var span = 0; span < spline.Spans.Count; span++)
            {
                var (from, to) = spline.Spans[span];
                foreach (var part in new[] { 0.0, 0.31, 0.77, 0.999999 })
                {
                    var expected = spline.At(from + (part * (to - from)));
                    var found = curve.Spans[span].EvaluateInSpace(part, out _);
                    Assert.True(Math.Abs(expected[0] - found.X) + Math.Abs(expected[1] - found.Y) + Math.Abs(expected[2] - found.Z) < 1e-7, $"seed {seed}, span {span} at {part}");
                }
            }
        }
    }

    /// <summary>The error of the sum of chords falls with the square of their number, so that two sums give a much better length.</summary>
    [Fact]
    public void Its_length_is_the_sum_of_many_small_chords()
    {
        for (var seed = 1; seed <= 40; seed++)
        {
            var spline = Spline.Random(new Random(seed));
            var length = 0.0;
            foreach (var (from, to) in spline.Spans)
            {
                var places = Enumerable.Range(0, 1001).Select(i => spline.At(Math.Min(from + ((to - from) * i / 1000.0), Math.BitDecrement(to)))).ToArray();
                length += ((4.0 * Chords(places)) - Chords([.. places.Where((_, i) => i % 2 == 0)])) / 3.0;
            }

            Assert.Equal(1.0, DrawingSummary.From(DxfReading.Entities(spline.Pairs())).Length.Total / length, 1e-8);
        }
    }

    private static double Chords(double[][] places) =>
        places.Zip(places.Skip(1), (a, b) => Math.Sqrt(Math.Pow(a[0] - b[0], 2) + Math.Pow(a[1] - b[1], 2) + Math.Pow(a[2] - b[2], 2))).Sum();

    private sealed record Spline(int Degree, double[] Knots, double[] Weights, double[][] Controls)
    {
        /// <summary>Knot intervals that are not empty, within the domain.</summary>
        public List<(double From, double To)> Spans => [.. Enumerable.Range(Degree, Controls.Length - Degree).Where(k => Knots[k] < Knots[k + 1]).Select(k => (Knots[k], Knots[k + 1]))];

        public static Spline Random(Random random)
        {
            var degree = random.Next(1, 8);
            var count = degree + 1 + random.Next(7);
            double[] inner = [.. Enumerable.Range(0, count - degree - 1).Select(_ => random.Next(2) == 0 ? random.Next(1, 6) : 0.5 + (5.0 * random.NextDouble())).Order()];
            for (var i = degree; i < inner.Length; i++)
            {
                if (inner[i] == inner[i - degree]) inner[i] = Math.BitIncrement(inner[i]) + 0.01; // no more than full multiplicity
            }

            Array.Sort(inner);
            var clamped = random.Next(3) > 0;
            double[] knots = clamped
                ? [.. Enumerable.Repeat(0.0, degree + 1), .. inner, .. Enumerable.Repeat(7.0, degree + 1)]
                : [.. Enumerable.Range(0, count + degree + 1).Select(i => (0.75 * i) - 3.0)];
            double[] weights = [.. Enumerable.Range(0, count).Select(_ => random.Next(2) == 0 ? 1.0 : 0.2 + (3.0 * random.NextDouble()))];
            return new Spline(degree, knots, weights, [.. Enumerable.Range(0, count).Select(_ => new[] { 100.0 * random.NextDouble(), 100.0 * random.NextDouble(), random.Next(3) * 10.0 })]);
        }

        public (int, object)[] Pairs() =>
        [
            (0, "SPLINE"), (70, 4), (71, Degree), (72, Knots.Length), (73, Controls.Length), .. Knots.Select(knot => (40, (object)knot)), .. Weights.Select(weight => (41, (object)weight)),
            .. Controls.SelectMany(point => new[] { (10, (object)point[0]), (20, point[1]), (30, point[2]) }),
        ];

        public double[] At(double u)
        {
            var shares = Enumerable.Range(0, Controls.Length).Select(i => Weights[i] * Basis(i, Degree, u)).ToArray();
            return [.. Enumerable.Range(0, 3).Select(axis => shares.Zip(Controls, (share, point) => share * point[axis]).Sum() / shares.Sum())];
        }

        private double Basis(int i, int degree, double u)
        {
            if (degree == 0) return Knots[i] <= u && u < Knots[i + 1] ? 1.0 : 0.0;
            var (rising, falling) = (Knots[i + degree] - Knots[i], Knots[i + degree + 1] - Knots[i + 1]);
            return (rising == 0.0 ? 0.0 : (u - Knots[i]) / rising * Basis(i, degree - 1, u)) + (falling == 0.0 ? 0.0 : (Knots[i + degree + 1] - u) / falling * Basis(i + 1, degree - 1, u));
        }
    }
}
