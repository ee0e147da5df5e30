using Engraver.Core.Geometry;
using Engraver.Core.Unions;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Unions;

/// <summary>Seeded contours of every kind, judged by <see cref="UnionWitness"/>.</summary>
public class RandomUnionTests
{
    /// <summary>Full run: 20,000 seeds.</summary>
    private static readonly int Seeds = TestExtent.Cases(perCommit: 300, full: 20_000, "ENGRAVER_UNION_SEEDS");

    [Fact]
    public void The_result_covers_what_the_contours_run_around_and_nothing_else()
    {
        for (var seed = 0; seed < Seeds; seed++) Judge(seed, Transform2D.Identity, 1e-9);
    }

    /// <summary>A size, a place far from the origin, and a tolerance, each a few powers of ten apart.</summary>
    [Theory]
    [InlineData(1e-4, 0.0, 1e-13)]
    [InlineData(1e4, 0.0, 1e-6)]
    [InlineData(1.0, 1e5, 1e-8)]
    [InlineData(1e4, 1e6, 1e-5)]
    [InlineData(1.0, 0.0, 1e-6)]
    [InlineData(1.0, 0.0, 1e-16)]
    public void Neither_size_nor_place_nor_tolerance_changes_it(double scale, double place, double tolerance)
    {
        for (var seed = 0; seed < Seeds / 6; seed++) Judge(seed, new Transform2D(scale, Angle.FromDegrees(17.0), seed % 2 == 1, new Vector2D(place, -0.7 * place)), tolerance);
    }

    [Fact]
    public void Copies_that_almost_coincide_are_united()
    {
        for (var seed = 0; seed < Seeds; seed++) Judge(seed, SeededUnions.AlmostEqual(seed), 1e-9);
    }

    private static void Judge(int seed, Transform2D map, double tolerance) => Judge(seed, SeededUnions.Mapped(SeededUnions.Of(seed), map), tolerance);

    private static void Judge(int seed, IReadOnlyList<IReadOnlyList<Segment>> contours, double tolerance)
    {
        var fault = new UnionWitness(contours).Fault(ContourUnion.Unite(contours, tolerance), 24);
        Assert.True(fault is null, FormattableString.Invariant($"seed {seed}: {fault}"));
    }
}
