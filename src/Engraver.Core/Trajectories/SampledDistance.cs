using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>The largest distance of what is run from its chain at dense samples, millimetres: what is reached, so never above a proven bound.</summary>
internal static class SampledDistance
{
    /// <summary>Steps between the samples of one element, its ends included.</summary>
    private const int Dense = 32;

    /// <param name="knots">The lengths along the chain near which the cubics begin and end, one more than cubics.</param>
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

    /// <param name="run">Lines and arcs that follow the chain from its start to its end, at nearly its length.</param>
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
