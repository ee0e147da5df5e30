using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>A source piece moved to its left by the distance, and the used part of it.</summary>
internal struct ShiftedPiece
{
    public ShiftedPiece()
    {
    }

    public PathPiece Piece { get; private init; }

    /// <summary>False for an arc whose radius is not larger than the distance: the points on the far side of its centre are all nearer to it than the
    /// distance.</summary>
    public bool Exists { get; private init; }

    /// <summary>True for an arc whose radius is the distance: its offset is its centre, where its neighbours meet.</summary>
    public bool IsPoint { get; private init; }

    public int StartNode { get; set; }

    public int EndNode { get; set; }

    /// <summary>Node of the tip of a mitre before an arc; -1 for none.</summary>
    public int TipAhead { get; set; } = -1;

    /// <summary>The same after the arc.</summary>
    public int TipBehind { get; set; } = -1;

    /// <summary>Fractions of the piece between which it is used.</summary>
    public double From { get; set; }

    public double To { get; set; }

    public static ShiftedPiece LeftOf(in PathPiece source, double distance, double tolerance)
    {
        var (start, end) = (source.Start + (Left(source.StartTangent) * distance), source.End + (Left(source.EndTangent) * distance));
        if (!source.IsArc) return new ShiftedPiece { Piece = PathPiece.Line(start, end), Exists = true, To = 1.0 };
        var radius = source.Radius - (Math.Sign(source.Sweep) * distance);
        if (radius <= tolerance) return new ShiftedPiece { IsPoint = radius >= -tolerance };
        return new ShiftedPiece { Piece = PathPiece.Arc(source.Centre, radius, source.From, source.Sweep, start, source.IsWholeTurn ? start : end), Exists = true, To = 1.0 };
    }

    /// <summary>False when the nodes at its ends have passed each other, which leaves nothing.</summary>
    public readonly bool KeepsDirection(Point2D start, Point2D end)
    {
        if (Piece.IsArc) return Piece.IsWholeTurn || Math.Abs(Piece.Sweep) - CutAhead(start) - CutBehind(end) > 0.0;
        return (Piece.End - Piece.Start).Dot(end - start) > 0.0;
    }

    /// <summary>The used part between the places of its nodes.</summary>
    public readonly PathPiece Trimmed(Point2D start, Point2D end)
    {
        if (!Piece.IsArc) return PathPiece.Line(start, end);
        if (Piece.IsWholeTurn && From == 0.0 && To == 1.0) return Piece.Part(0.0, start, 1.0, end);
        var (direction, ahead) = (Math.Sign(Piece.Sweep), CutAhead(start));
        return PathPiece.Arc(Piece.Centre, Piece.Radius, Piece.From + (direction * ahead), direction * (Math.Abs(Piece.Sweep) - ahead - CutBehind(end)), start, end);
    }

    /// <summary>Radians cut off at the start of an arc; a node that only smooths a joint can also be slightly before it (negative).</summary>
    private readonly double CutAhead(Point2D start) => From > 0.0 ? From * Math.Abs(Piece.Sweep) : Turn(Piece.Start, start);

    private readonly double CutBehind(Point2D end) => To < 1.0 ? (1.0 - To) * Math.Abs(Piece.Sweep) : Turn(end, Piece.End);

    /// <summary>Signed angle about the centre in the direction of travel, radians.</summary>
    private readonly double Turn(Point2D from, Point2D to)
    {
        var (first, second) = (from - Piece.Centre, to - Piece.Centre);
        return Math.Sign(Piece.Sweep) * Math.Atan2(first.Cross(second), first.Dot(second));
    }

    private static Vector2D Left(Vector2D tangent) => new(-tangent.Y, tangent.X);
}
