using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>A proven bound in space of the distance between a spline whose points have heights and its chain with heights that change evenly from knot to knot:
/// both are evaluated at the same fraction of every step.</summary>
/// <remarks>
/// The difference D(u) of both is known at equal places, and between two of them |D| is at most the larger of its ends plus du^2/8 max|D''| (error of linear
/// interpolation). D'' is that of the cubic, which is linear in u, and that of the chain, step^2 times its curvature; so only chains of lines and arcs without
/// corners are supported.
/// </remarks>
internal static class SpaceBound
{
    private const int Parts = 128;

    private const double Rounding = 64.0 * 2.220446049250313e-16;

    /// <returns>The bound, millimetres; infinite when the chain has a corner or a curve whose curvature is not known exactly.</returns>
    public static double Measure(CatmullRomSpline spline, IReadOnlyList<double> heights, SmoothChain chain, IReadOnlyList<double> knots)
    {
        if (chain.Closed || chain.Pieces.Any(piece => piece.IsFree) || chain.Joints.Any(joint => joint.IsCorner)) return double.PositiveInfinity;
        var (curvature, largest, far) = (chain.Pieces.Max(piece => Math.Abs(piece.At(0.5).Curvature)), 0.0, 0.0);
        for (var i = 0; i < spline.Count; i++)
        {
            var (cubic, step, z) = (spline[i], knots[i + 1] - knots[i], HeightControls(heights, i));
            var bend = (step * step * curvature) + LargestBend(cubic, z);
            var most = 0.0;
            for (var k = 0; k <= Parts; k++)
            {
                var u = (double)k / Parts;
                var beside = cubic.At(u) - chain.At(knots[i] + (u * step)).Point;
                most = Math.Max(most, double.Hypot(beside.Length, HeightAt(z, u) - (heights[i + 1] + (u * (heights[i + 2] - heights[i + 1])))));
            }

            largest = Math.Max(largest, most + (bend / (8.0 * Parts * Parts)));
            far = Math.Max(far, Math.Abs(cubic.A.X) + Math.Abs(cubic.A.Y) + Math.Abs(heights[i + 1]));
        }

        return largest + (Rounding * (far + chain.Length));
    }

    /// <summary>The heights as a Bezier polygon, like the plan.</summary>
    public static double[] HeightControls(IReadOnlyList<double> heights, int segment)
    {
        var (before, start, end, after) = (heights[segment], heights[segment + 1], heights[segment + 2], heights[segment + 3]);
        return [start, start + ((end - before) / 6.0), end - ((after - start) / 6.0), end];
    }

    public static double HeightAt(double[] z, double u)
    {
        var v = 1.0 - u;
        return (v * v * v * z[0]) + (3.0 * v * v * u * z[1]) + (3.0 * v * u * u * z[2]) + (u * u * u * z[3]);
    }

    /// <summary>Largest size of the second derivative of a cubic with its heights, which is linear.</summary>
    public static double LargestBend(in Cubic cubic, double[] z) => Math.Max(Bend(cubic.A, cubic.B, cubic.C, z[0], z[1], z[2]), Bend(cubic.B, cubic.C, cubic.D, z[1], z[2], z[3]));

    /// <summary>Size of the second derivative at an end of a cubic.</summary>
    private static double Bend(Point2D a, Point2D b, Point2D c, double za, double zb, double zc) =>
        6.0 * double.Hypot((a - b - (b - c)).Length, za - (2.0 * zb) + zc);
}
