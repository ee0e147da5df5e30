using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Pockets;
using Engraver.Core.Tests.Offsets;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Pockets;

/// <summary>Seeded shapes with islands, judged by <see cref="PocketWitness"/>: the whole reachable area is covered by exact area and by raster, walls are not
/// touched, links do not cross the material.</summary>
public class RandomPocketTests
{
    private static readonly int Seeds = TestExtent.Cases(perCommit: 8, full: 50, "ENGRAVER_POCKET_SEEDS");

    [Theory]
    [InlineData(PocketStrategy.Contour, false, 0.0)]
    [InlineData(PocketStrategy.Contour, true, 0.0)]
    [InlineData(PocketStrategy.Contour, false, 0.3)]
    [InlineData(PocketStrategy.Zigzag, false, 0.0)]
    [InlineData(PocketStrategy.Zigzag, false, 0.3)]
    public void Everything_that_can_be_reached_is_covered_and_no_wall_is_touched(PocketStrategy strategy, bool fromCentre, double allowance)
    {
        for (var seed = 0; seed < Seeds; seed++) Judge(seed, strategy, fromCentre, allowance);
    }

    /// <summary>An island across the wall, which an offset by a ten-millionth of a millimetre did not separate from it: the island beside it was cleared
    /// instead of the pocket.</summary>
    [Theory]
    [InlineData(19)]
    [InlineData(107)]
    public void Contours_that_cross_are_parted(int seed)
    {
        Judge(seed, PocketStrategy.Contour, fromCentre: false, 0.0);
        Judge(seed, PocketStrategy.Zigzag, fromCentre: false, 0.0);
    }

    /// <summary>Stepovers from 0.3 to 0.95 and angles in steps of 24 degrees on one shape.</summary>
    [Fact]
    public void Every_stepover_and_angle_leaves_nothing()
    {
        var contours = SeededPockets.Of(7);
        for (var step = 0; step <= 13; step++)
        {
            var options = UsualOptions.Pocket(0.9, 0.3 + (0.05 * step)) with { Angle = Angle.FromDegrees(24.0 * step) };
            foreach (var strategy in new[] { PocketStrategy.Contour, PocketStrategy.Zigzag }) Judge(contours, options with { Strategy = strategy }, FormattableString.Invariant($"overlap {options.Stepover}"));
        }
    }

    private static void Judge(int seed, PocketStrategy strategy, bool fromCentre, double allowance)
    {
        var random = new Random(seed + 1000);
        var radius = 0.4 + (1.2 * random.NextDouble());
        var options = UsualOptions.Pocket(radius, 0.3 + (0.65 * random.NextDouble())) with
        {
            Strategy = strategy,
            Angle = Angle.FromDegrees(360.0 * random.NextDouble()),
            FromCentre = fromCentre,
            Allowance = allowance * radius,
        };
        Judge(SeededPockets.Of(seed), options, FormattableString.Invariant($"seed {seed}, {strategy}"));
    }

    private static void Judge(IReadOnlyList<OffsetContour> contours, PocketOptions options, string what)
    {
        var fault = new PocketWitness(contours, options).Fault(PocketPlanner.Plan(contours, options), 30);
        Assert.True(fault is null, $"{what}: {fault}");
    }
}

/// <summary>An outer contour of lines and arcs about the origin and up to five islands, from a seed; islands may cross each other and the wall.</summary>
internal static class SeededPockets
{
    public static IReadOnlyList<OffsetContour> Of(int seed)
    {
        var random = new Random(seed);
        var count = random.Next(4, 16);
        var outer = OffsetShapes.Chain(true, [.. Enumerable.Range(0, count).Select(i =>
        {
            var (radius, angle) = (20.0 * (0.45 + (0.55 * random.NextDouble())), 2.0 * Math.PI * i / count);
            return (radius * Math.Cos(angle), radius * Math.Sin(angle), random.Next(3) == 0 ? (random.NextDouble() - 0.5) * 0.8 : 0.0);
        })]);
        return [outer, .. Enumerable.Range(0, random.Next(0, 6)).Select(_ => Island(random))];
    }

    private static OffsetContour Island(Random random)
    {
        var (distance, angle, size) = (12.0 * random.NextDouble(), 2.0 * Math.PI * random.NextDouble(), 0.5 + (2.0 * random.NextDouble()));
        var (x, y) = (distance * Math.Cos(angle), distance * Math.Sin(angle));
        return random.Next(3) switch
        {
            0 => OffsetShapes.Circle(x, y, size),
            1 => OffsetShapes.Rectangle(x, y, size, 2.0 * size),
            _ => OffsetShapes.Chain(true, (x, y, 0.3), (x + size, y, 0.0), (x + size, y + size, -0.4)),
        };
    }
}
