using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets.Pieces;

/// <summary>The part of a raw piece within a radius of a source piece.</summary>
internal static class PieceReach
{
    /// <summary>Cuts off from either end of <paramref name="left"/> the part nearer to a source piece than a radius; for an arc as source, only the part near
    /// its ends.</summary>
    public static void Clip(in PathPiece piece, in PathPiece source, double radius, ref PiecePart left)
    {
        if (piece.IsArc)
        {
            ClipArc(piece, source.Start, radius, ref left);
            ClipArc(piece, source.End, radius, ref left);
        }
        else
        {
            ClipLine(piece, source, radius, ref left);
        }
    }

    /// <summary>The fraction up to which a piece is covered from another fraction on.</summary>
    public static double CoveredFrom(in PathPiece piece, double from, in PathPiece source, double radius)
    {
        var left = new PiecePart(from, 1.0);
        Clip(piece, source, radius, ref left);
        return left.IsEmpty ? 1.0 : left.From;
    }

    /// <summary>A line within the reach of another line: its common part with the strip and the two circles, which together are convex.</summary>
    private static void ClipLine(in PathPiece line, in PathPiece source, double radius, ref PiecePart left)
    {
        var along = (line.End - line.Start) * (1.0 / line.Length);
        var covered = InCircle(line.Start, along, source.Start, radius).Hull(InCircle(line.Start, along, source.End, radius));
        if (!source.IsArc) covered = covered.Hull(InStrip(line.Start, along, source, radius));
        if (source.IsArc && !covered.IsEmpty) // two circles alone are not convex
        {
            left.CutOff(InCircle(line.Start, along, source.Start, radius).Scaled(line.Length));
            left.CutOff(InCircle(line.Start, along, source.End, radius).Scaled(line.Length));
            return;
        }

        left.CutOff(covered.Scaled(line.Length));
    }

    private static PiecePart InCircle(Point2D start, Vector2D along, Point2D centre, double radius)
    {
        var spoke = centre - start;
        var height = along.Cross(spoke);
        if (Math.Abs(height) >= radius) return PiecePart.Empty;
        var half = Math.Sqrt((radius - height) * (radius + height));
        var foot = along.Dot(spoke);
        return new PiecePart(foot - half, foot + half);
    }

    private static PiecePart InStrip(Point2D start, Vector2D along, in PathPiece source, double radius)
    {
        var direction = (source.End - source.Start) * (1.0 / source.Length);
        var way = start - source.Start;
        var beside = Within(direction.Dot(way), direction.Dot(along), 0.0, source.Length);
        return beside.Common(Within(direction.Cross(way), direction.Cross(along), -radius, radius));
    }

    /// <summary>The interval in which at + slope * t is between two values.</summary>
    private static PiecePart Within(double at, double slope, double low, double high)
    {
        if (Math.Abs(slope) < 1e-15) return at > low && at < high ? new PiecePart(double.NegativeInfinity, double.PositiveInfinity) : PiecePart.Empty;
        var (first, second) = ((low - at) / slope, (high - at) / slope);
        return new PiecePart(Math.Min(first, second), Math.Max(first, second));
    }

    /// <summary>Uses the sine of a quarter of the covered angle: its cosine is 1 within rounding on a circle of 300 m, with which some curves are
    /// approximated.</summary>
    private static void ClipArc(in PathPiece arc, Point2D corner, double radius, ref PiecePart left)
    {
        var spoke = corner - arc.Centre;
        var height = PathPiece.Norm(spoke);
        if (height == 0.0) return;
        var away = arc.Radius - height;
        var squaredSine = (radius - away) * (radius + away) / (4.0 * height * arc.Radius);
        if (squaredSine <= 0.0) return;
        var half = squaredSine >= 1.0 ? Math.PI : 2.0 * Math.Asin(Math.Sqrt(squaredSine));
        var (middle, sweep) = (arc.AngleAhead(spoke), Math.Abs(arc.Sweep));
        left.CutOff(new PiecePart(middle - half, middle + half).Scaled(sweep));
        left.CutOff(new PiecePart(middle - half - (2.0 * Math.PI), middle + half - (2.0 * Math.PI)).Scaled(sweep));
    }
}

/// <summary>Shortening of the remaining part.</summary>
internal static class PartCut
{
    /// <summary>Removes a covered part at either end; a covered part in the middle is kept.</summary>
    public static void CutOff(ref this PiecePart left, PiecePart covered)
    {
        if (covered.IsEmpty) return;
        if (covered.From <= left.From && covered.To > left.From) left = left with { From = covered.To };
        else if (covered.To >= left.To && covered.From < left.To) left = left with { To = covered.From };
    }
}
