using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>Cuts off from a raw piece what lies clearly nearer than the distance to near pieces of its chain.</summary>
/// <remarks>Where the distance is large against the pieces nearly all of the raw offset is nonsense of this kind, and would cross itself in a number of points that grows with the square. What is
/// cut off is certainly too near; what is left is judged later, so that it does not matter how much is left.</remarks>
internal sealed class NeighbourCover(PathPiece[] chain, double distance, bool circlesAreTaken)
{
    /// <summary>Part of the distance by which what is cut off must be nearer.</summary>
    private const double Depth = 1e-6;

    private readonly double _radius = distance * (1.0 - Depth);

    /// <param name="piece">A raw piece.</param>
    /// <param name="ahead">Number of the first source piece ahead of its own.</param>
    /// <param name="behind">The same backwards.</param>
    /// <param name="left">The part to look at, and what is left of it.</param>
    /// <returns>False when nothing is left.</returns>
    public bool TryClip(in PathPiece piece, int ahead, int behind, ref PiecePart left)
    {
        if (!circlesAreTaken || chain.Length < 3) return true;
        var reach = (2.0 * distance) + piece.Length;
        var (middle, goesAhead, goesBehind) = (piece.At(0.5), true, true);
        for (var step = 0; step < chain.Length && (goesAhead || goesBehind); step = step < 2 ? step + 1 : step * 2)
        {
            if (goesAhead) goesAhead = Clip(piece, middle, reach, Numbered(ahead + step), ref left);
            if (goesBehind) goesBehind = Clip(piece, middle, reach, Numbered(behind - step), ref left);
            if (left.IsEmpty) return false;
        }

        return true;
    }

    private ref readonly PathPiece Numbered(int number) => ref chain[((number % chain.Length) + chain.Length) % chain.Length];

    /// <returns>False when the source piece is out of reach.</returns>
    private bool Clip(in PathPiece piece, Point2D middle, double reach, in PathPiece source, ref PiecePart left)
    {
        if ((source.Start - middle).LengthSquared > reach * reach && (source.End - middle).LengthSquared > reach * reach) return false;
        if (piece.IsArc)
        {
            ClipArc(piece, source.Start, ref left);
            ClipArc(piece, source.End, ref left);
        }
        else
        {
            ClipLine(piece, source, ref left);
        }

        return true;
    }

    /// <summary>A line within the reach of another line: what it has in common with the strip and the two circles, which together are convex.</summary>
    private void ClipLine(in PathPiece line, in PathPiece source, ref PiecePart left)
    {
        var along = (line.End - line.Start) * (1.0 / line.Length);
        var covered = InCircle(line.Start, along, source.Start).Hull(InCircle(line.Start, along, source.End));
        if (!source.IsArc) covered = covered.Hull(InStrip(line.Start, along, source));
        if (source.IsArc && !covered.IsEmpty) // two circles alone are not convex
        {
            left.CutOff(InCircle(line.Start, along, source.Start).Scaled(line.Length));
            left.CutOff(InCircle(line.Start, along, source.End).Scaled(line.Length));
            return;
        }

        left.CutOff(covered.Scaled(line.Length));
    }

    private PiecePart InCircle(Point2D start, Vector2D along, Point2D centre)
    {
        var spoke = centre - start;
        var height = along.Cross(spoke);
        if (Math.Abs(height) >= _radius) return PiecePart.Empty;
        var half = Math.Sqrt((_radius - height) * (_radius + height));
        var foot = along.Dot(spoke);
        return new PiecePart(foot - half, foot + half);
    }

    private PiecePart InStrip(Point2D start, Vector2D along, in PathPiece source)
    {
        var direction = (source.End - source.Start) * (1.0 / source.Length);
        var way = start - source.Start;
        var beside = Within(direction.Dot(way), direction.Dot(along), 0.0, source.Length);
        return beside.Common(Within(direction.Cross(way), direction.Cross(along), -_radius, _radius));
    }

    /// <summary>Where at + slope * t lies between two values.</summary>
    private static PiecePart Within(double at, double slope, double low, double high)
    {
        if (Math.Abs(slope) < 1e-15) return at > low && at < high ? new PiecePart(double.NegativeInfinity, double.PositiveInfinity) : PiecePart.Empty;
        var (first, second) = ((low - at) / slope, (high - at) / slope);
        return new PiecePart(Math.Min(first, second), Math.Max(first, second));
    }

    /// <summary>By the sine of a quarter of what is covered: its cosine is 1 within rounding on a circle of 300 m, which some curves are fitted with.</summary>
    private void ClipArc(in PathPiece arc, Point2D corner, ref PiecePart left)
    {
        var spoke = corner - arc.Centre;
        var height = PathPiece.Norm(spoke);
        if (height == 0.0) return;
        var away = arc.Radius - height;
        var squaredSine = (_radius - away) * (_radius + away) / (4.0 * height * arc.Radius);
        if (squaredSine <= 0.0) return;
        var half = squaredSine >= 1.0 ? Math.PI : 2.0 * Math.Asin(Math.Sqrt(squaredSine));
        var (middle, sweep) = (arc.AngleAhead(spoke), Math.Abs(arc.Sweep));
        left.CutOff(new PiecePart(middle - half, middle + half).Scaled(sweep));
        left.CutOff(new PiecePart(middle - half - (2.0 * Math.PI), middle + half - (2.0 * Math.PI)).Scaled(sweep));
    }
}

/// <summary>A part of a piece, by fractions of its length or lengths along it.</summary>
internal readonly record struct PiecePart(double From, double To)
{
    public static PiecePart Empty => new(double.PositiveInfinity, double.NegativeInfinity);

    public static PiecePart Whole => new(0.0, 1.0);

    public bool IsEmpty => !(From < To);

    public PiecePart Hull(PiecePart other) => IsEmpty ? other : other.IsEmpty ? this : new PiecePart(Math.Min(From, other.From), Math.Max(To, other.To));

    public PiecePart Common(PiecePart other) => new(Math.Max(From, other.From), Math.Min(To, other.To));

    public PiecePart Scaled(double length) => new(From / length, To / length);
}

/// <summary>Shortening of what is left.</summary>
internal static class PartCut
{
    /// <summary>Takes away a covered part at either end; one in the middle is left where it is.</summary>
    public static void CutOff(ref this PiecePart left, PiecePart covered)
    {
        if (covered.IsEmpty) return;
        if (covered.From <= left.From && covered.To > left.From) left = left with { From = covered.To };
        else if (covered.To >= left.To && covered.From < left.To) left = left with { To = covered.From };
    }
}
