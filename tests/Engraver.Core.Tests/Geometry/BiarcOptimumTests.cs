using Engraver.Core.Dxf;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Geometry;

/// <summary>Compares the number of arcs with the minimum found by dynamic programming.</summary>
public class BiarcOptimumTests
{
    private const double MaxRatio = 1.3;

    [Theory]
    [InlineData(0.001)]
    [InlineData(0.01)]
    [InlineData(0.1)]
    public void Ellipses_take_hardly_more_pieces_than_the_optimum(double maxError)
    {
        var random = new Random(7);
        AssertNearOptimum([.. Enumerable.Range(0, 24).Select(_ => FreeCurves.Ellipse(
            0.0, 0.0, 1.0 + (40.0 * random.NextDouble()), 0.05 + random.NextDouble(), random.Next(360), random.Next(360), random.Next(3) == 0 ? 360.0 : random.Next(10, 350)).ToCurve())], maxError);
    }

    [Theory]
    [InlineData(0.01)]
    [InlineData(0.1)]
    public void Splines_take_hardly_more_pieces_than_the_optimum(double maxError)
    {
        var random = new Random(11);
        AssertNearOptimum([.. Enumerable.Range(0, 16).Select(_ =>
        {
            var count = random.Next(4, 9);
            return FreeCurves.Spline(
                3, [.. Enumerable.Range(0, count).Select(i => new Point2D((10.0 * i) + random.Next(8), random.Next(30)))], [.. Enumerable.Range(0, count).Select(_ => 0.5 + random.NextDouble())]);
        })], maxError);
    }

    [CorpusFact]
    public void Curves_of_real_drawings_take_hardly_more_pieces_than_the_optimum()
    {
        var corpus = RepositoryFolder.Corpus!;
        var judged = 0;
        var every = TestExtent.Cases(perCommit: 6, full: 1, "ENGRAVER_OPTIMUM_EVERY"); // a commit tests every sixth drawing
        foreach (var path in Directory.EnumerateFiles(Path.Combine(corpus, "files"), "*", SearchOption.AllDirectories).Order(StringComparer.Ordinal).Where((_, i) => i % every == 0))
        {
            var drawing = DxfReader.Read(File.ReadAllBytes(path), path, DxfReadOptions.Default, CancellationToken.None);
            foreach (var curve in drawing.Curves.Take(2).Select(curve => drawing.Scale.ToMillimetres(curve)))
            {
                if (!(curve.PlanLength is > 0.001 and < 1000.0) || ArcSplineOptimum.Pieces(curve, 0.01) is not { } fewest) continue;
                judged++;
                Assert.True(BiarcFit.Fit(curve, 0.01).Count <= MaxRatio * fewest, $"{path}: {BiarcFit.Fit(curve, 0.01).Count} pieces, {fewest} would do");
            }
        }

        Assert.True(judged > (TestExtent.IsFull ? 80 : 10), $"Only {judged} curves could be judged.");
    }

    /// <summary>Test of the judge itself: a circle needs arcs of just under a half turn, a straight spline one line.</summary>
    [Fact]
    public void The_optimum_of_a_circle_is_a_few_arcs() => Assert.InRange(ArcSplineOptimum.Pieces(RationalCurveTests.Circle(), 0.001) ?? 0, 2, 4);

    private static void AssertNearOptimum(RationalCurve[] curves, double maxError)
    {
        var ratios = new List<double>();
        foreach (var curve in curves)
        {
            if (ArcSplineOptimum.Pieces(curve, maxError) is { } fewest) ratios.Add(BiarcFit.Fit(curve, maxError).Count / (double)fewest);
        }

        Assert.True(ratios.Count >= curves.Length / 2, $"Only {ratios.Count} curves could be judged.");
        Assert.InRange(ratios.Average(), 0.0, 1.05);
        Assert.InRange(ratios.Max(), 0.0, MaxRatio);
    }
}
