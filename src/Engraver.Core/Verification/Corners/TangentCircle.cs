using Engraver.Core.Geometry;

namespace Engraver.Core.Verification.Corners;

/// <summary>The largest circle that touches both sides of a corner, passes within the corner tolerance of the corner point and touches each side within a
/// length of it. It is found from the drawing alone.</summary>
/// <param name="Centre">Relative to the corner point, millimetres.</param>
/// <param name="First">Length from the corner point to the contact with the first side.</param>
/// <param name="Second">The same for the second side.</param>
internal readonly record struct TangentCircle(Vector2D Centre, double Radius, double First, double Second)
{
    private const int MaxSteps = 20;
    private const int MaxDoublings = 24;
    private const int Halvings = 44;
    private const double Known = 1e-13;

    /// <param name="tolerance">Largest distance of the circle from the corner point.</param>
    /// <param name="longest">Largest length on the first side.</param>
    /// <param name="longestSecond">Largest length on the second side.</param>
    public static TangentCircle Largest(DrawnSide first, DrawnSide second, double tolerance, double longest, double longestSecond)
    {
        var half = Math.Atan2(Math.Abs(first.Along.Cross(second.Along)), first.Along.Dot(second.Along)) / 2.0;
        var contact = Math.Min(Math.Min(longest, longestSecond), tolerance * Math.Cos(half) / (1.0 - Math.Sin(half)));
        var radius = contact * Math.Tan(half);
        var straight = new TangentCircle((first.Along * contact) + (first.Inward * radius), radius, contact, contact);
        if (first.Curvature == 0.0 && second.Curvature == 0.0) return straight;
        var (best, high) = (new TangentCircle(default, 0.0, 0.0, 0.0), radius);
        for (var i = 0; i < MaxDoublings && Allowed(high, best) is { } larger; i++) (best, high) = (larger, 2.0 * high);
        for (var (i, low) = (0, best.Radius); i < Halvings; i++)
        {
            var middle = (low + high) / 2.0;
            if (Allowed(middle, best) is { } larger) (best, low) = (larger, middle);
            else high = middle;
        }

        return best;

        TangentCircle? Allowed(double tried, in TangentCircle smaller) => Of(first, second, tried, smaller.Radius > 0.0 ? smaller : straight) is { } found
            && found.First >= 0.0 && found.Second >= 0.0 && found.First <= longest && found.Second <= longestSecond
            && found.Centre.Length - tried <= tolerance ? found : null;
    }

    /// <summary>The circle of a radius, by Newton's steps from one of another radius; null when there is none near it.</summary>
    private static TangentCircle? Of(in DrawnSide first, in DrawnSide second, double radius, in TangentCircle near)
    {
        var scale = radius / near.Radius;
        var (one, other) = (near.First * scale, near.Second * scale);
        var (slow, slowSecond) = (1.0 - (radius * first.Curvature), 1.0 - (radius * second.Curvature));
        if (!(slow > 0.0 && slowSecond > 0.0)) return null;
        for (var step = 0; step < MaxSteps; step++)
        {
            var centre = first.At(one) + (first.InwardAt(one) * radius);
            var apart = second.At(other) + (second.InwardAt(other) * radius) - centre;
            if (apart.Length <= Known * (radius + one)) return new TangentCircle(centre, radius, one, other);
            var (along, back) = (first.TangentAt(one) * slow, second.TangentAt(other) * -slowSecond);
            var area = along.Cross(back);
            if (area == 0.0) return null;
            (one, other) = (one + (apart.Cross(back) / area), other + (along.Cross(apart) / area));
        }

        return null;
    }
}
