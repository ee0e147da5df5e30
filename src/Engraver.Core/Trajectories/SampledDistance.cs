using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>The largest distance of the executed path from its chain at dense samples, millimetres: a distance that is reached and therefore never above a
/// proven bound.</summary>
internal static class SampledDistance
{
    /// <summary>Number of steps between the samples of one element, including its ends.</summary>
    private const int Dense = 32;

    /// <param name="knots">The lengths along the chain near which the cubics start and end, one more than cubics.</param>
    public static double Of(int count, Func<int, Cubic> cubics, SmoothChain chain, IReadOnlyList<double> knots, int steps = Dense)
    {
        var largest = 0.0;
        for (var i = 0; i < count; i++)
        {
            var cubic = cubics(i);
            for (var k = 0; k <= steps; k++)
            {
                var at = (double)k / steps;
                largest = Math.Max(largest, Math.Abs(chain.Beside(cubic.At(at), knots[i] + (at * (knots[i + 1] - knots[i]))).Distance));
            }
        }

        return largest;
    }

    /// <param name="run">Lines and arcs that follow the chain from its start to its end, with nearly its length.</param>
    public static double Of(IReadOnlyList<Segment> run, SmoothChain chain)
    {
        var (largest, before, share) = (0.0, 0.0, chain.Length / run.Sum(element => element.Length));
        foreach (var element in run)
        {
            for (var k = 0; k <= Dense; k++)
            {
                var at = (double)k / Dense;
                largest = Math.Max(largest, Math.Abs(chain.Beside(element.PointAt(at), Math.Min(chain.Length, share * (before + (at * element.Length)))).Distance));
            }

            before += element.Length;
        }

        return largest;
    }
}
