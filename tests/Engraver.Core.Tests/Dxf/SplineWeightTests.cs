using System.Globalization;
using Engraver.Core.Geometry.Biarcs;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Rational splines whose weights differ by many powers of ten: measured correctly, or refused with the entity named.</summary>
public class SplineWeightTests
{
    private static readonly (double X, double Y)[] Places = [(0, 0), (10, 20), (30, 20), (40, 0)];

    [Theory]
    [InlineData(1, 1, 1, 1)]
    [InlineData(1, 100, 1, 1)]
    [InlineData(1, 1e5, 1, 1)]
    [InlineData(1, 1e6, 1, 1)]
    [InlineData(1, 1, 1e6, 1)]
    [InlineData(1e6, 1, 1, 1)]
    [InlineData(1, 1e6, 1e6, 1)]
    [InlineData(1, 1e6, 1, 1e6)]
    [InlineData(1e-6, 1, 1e-3, 1e-6)]
    [InlineData(1, 1e-6, 1e-6, 1)]
    public void Up_to_a_ratio_of_a_million_lengths_and_arcs_are_right(double w0, double w1, double w2, double w3)
    {
        double[] weights = [w0, w1, w2, w3];
        var drawing = Read(weights);

        Assert.Empty(drawing.Diagnostics);
        var curve = Assert.Single(drawing.Curves);
        var expected = LengthOf(weights);
        Assert.True(Math.Abs(curve.PlanLength - expected) <= 1e-6 * expected, string.Create(CultureInfo.InvariantCulture, $"{curve.PlanLength} for {expected}"));
        var arcs = BiarcFit.Fit(curve, 0.005);
        Assert.InRange(arcs.Count, 1, 200);
        Assert.InRange(arcs.Sum(arc => arc.Length), expected * 0.999, expected * 1.001);
    }

    [Theory]
    [InlineData(1, 1e7, 1, 1)]
    [InlineData(1, 1e8, 1, 1)]
    [InlineData(1, 1, 1, 1e17)]
    [InlineData(1, 1e-17, 1, 1)]
    [InlineData(1e-40, 1, 1, 1)]
    [InlineData(1e-90, 1, 1e90, 1)]
    public void Beyond_it_the_spline_is_refused_by_name(double w0, double w1, double w2, double w3)
    {
        var drawing = Read([w0, w1, w2, w3]);

        Assert.Empty(drawing.Curves);
        var refused = Assert.Single(drawing.Balance.Refused);
        Assert.Equal(("SPLINE", "A1", "DXF0056"), (refused.Type, refused.Handle, refused.DiagnosticId));
        Assert.True(drawing.HasErrors);
    }

    private static Core.Drawings.Drawing Read(double[] weights) => DxfReading.Entities(
        [(0, "SPLINE"), (5, "A1"), (70, 4), (71, 3), .. new[] { 0.0, 0, 0, 0, 1, 1, 1, 1 }.Select(knot => (40, (object)knot)), .. weights.Select(weight => (41, (object)weight)), .. Places.SelectMany<(double X, double Y), (int, object)>(place => [(10, place.X), (20, place.Y)])]);

    /// <summary>Chords between parameters that are denser towards both ends by powers of ten, where a large weight determines most of the curve.</summary>
    private static double LengthOf(double[] weights)
    {
        var half = Enumerable.Range(0, 400_001).Select(i => 0.5 * Math.Pow(10.0, -16.0 * (1.0 - (i / 400_000.0)))).ToArray();
        var sum = 0.0;
        var last = PlaceAt(weights, 0.0, 1.0);
        foreach (var t in half) Step(PlaceAt(weights, t, 1.0 - t));
        foreach (var u in half.Reverse().Skip(1)) Step(PlaceAt(weights, 1.0 - u, u));
        Step(PlaceAt(weights, 1.0, 0.0));
        return sum;

        void Step((double X, double Y) next)
        {
            sum += double.Hypot(next.X - last.X, next.Y - last.Y);
            last = next;
        }
    }

    private static (double X, double Y) PlaceAt(double[] weights, double t, double u)
    {
        double[] shares = [u * u * u * weights[0], 3 * t * u * u * weights[1], 3 * t * t * u * weights[2], t * t * t * weights[3]];
        var whole = shares.Sum();
        return (Enumerable.Range(0, 4).Sum(i => shares[i] * Places[i].X) / whole, Enumerable.Range(0, 4).Sum(i => shares[i] * Places[i].Y) / whole);
    }
}
