using Engraver.Core.Geometry;

namespace Engraver.Core.Verification.Corners;

/// <summary>A side of a drawn corner: a line or an arc that leaves the corner point. A curve is replaced by the arc through its start and a point at the
/// length of interest.</summary>
/// <param name="Along">Direction in which it leaves the corner point, length 1.</param>
/// <param name="Inward">Direction from the side to the other side at the corner point: across <paramref name="Along"/>, length 1.</param>
/// <param name="Curvature">1/radius, positive when it bends inward; 0 for a line.</param>
/// <param name="Pieces">Drawn pieces, from the corner point on: one for a line or an arc, those of a curve.</param>
/// <param name="IsFromStart">True when the pieces leave the corner point in their own direction.</param>
internal readonly record struct DrawnSide(Vector2D Along, Vector2D Inward, double Curvature, int[] Pieces, bool IsFromStart)
{
    /// <summary>The place at a length from the corner point, relative to it, millimetres.</summary>
    public Vector2D At(double length)
    {
        var turn = Curvature * length;
        if (turn == 0.0) return Along * length;
        var half = Math.Sin(turn / 2.0);
        return (Along * (Math.Sin(turn) / Curvature)) + (Inward * (2.0 * half * half / Curvature));
    }

    /// <summary>Direction of travel at a length from the corner point.</summary>
    public Vector2D TangentAt(double length) => (Along * Math.Cos(Curvature * length)) + (Inward * Math.Sin(Curvature * length));

    /// <summary>Inward direction across the side at a length from the corner point.</summary>
    public Vector2D InwardAt(double length) => (Inward * Math.Cos(Curvature * length)) - (Along * Math.Sin(Curvature * length));

    /// <summary>Distance of a place from the line or the whole circle of the side, positive inside the corner, millimetres.</summary>
    /// <param name="spoke">The place relative to the corner point.</param>
    public double Inside(Vector2D spoke)
    {
        var across = spoke.Dot(Inward) - (Curvature * spoke.LengthSquared / 2.0);
        return 2.0 * across / (1.0 + Math.Sqrt(Math.Max(0.0, 1.0 - (2.0 * Curvature * across))));
    }

    /// <summary>The smallest <see cref="Inside"/> of a line or an arc.</summary>
    /// <param name="corner">The corner point.</param>
    public double LeastInside(Point2D corner, in Segment part)
    {
        if (Curvature == 0.0) return FarthestDistance.LinearRange(corner, Inward, part).Min;
        var (least, most) = FarthestDistance.RadialRange(corner + (Inward * (1.0 / Curvature)), part);
        return Curvature > 0.0 ? (1.0 / Curvature) - most : least + (1.0 / Curvature);
    }
}
