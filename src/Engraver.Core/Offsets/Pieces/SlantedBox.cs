using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets.Pieces;

/// <summary>A box at any angle: around a long slanted line it is as thin as the line, while an upright box would overlap a thousand neighbours.</summary>
/// <remarks>Rounding can leave the enclosed points outside by 1e-16 of the coordinates; the caller allows more (the tolerance of an offset is 1e-14 of
/// them).</remarks>
/// <param name="Middle">Centre of the box.</param>
/// <param name="Along">Direction of its first side, length 1.</param>
/// <param name="HalfLength">Half the side in that direction.</param>
/// <param name="HalfWidth">Half the side across.</param>
internal readonly record struct SlantedBox(Point2D Middle, Vector2D Along, double HalfLength, double HalfWidth)
{
    private static readonly Vector2D s_upright = new(1.0, 0.0);

    private double Area => HalfLength * HalfWidth;

    private Vector2D Across => new(-Along.Y, Along.X);

    /// <summary>Box around a piece: along a line, or along the chord of an arc of up to half a turn; upright around a longer arc.</summary>
    public static SlantedBox Of(in PathPiece piece)
    {
        if (!piece.IsArc) return new SlantedBox(MiddleOf(piece), (piece.End - piece.Start) * (1.0 / piece.Length), piece.Length / 2.0, 0.0);
        var chord = piece.End - piece.Start;
        var length = PathPiece.Norm(chord);
        if (Math.Abs(piece.Sweep) > Math.PI || length == 0.0) return Upright(piece.Box());
        var along = chord * (1.0 / length);
        var sine = Math.Sin(piece.Sweep / 4.0);
        var height = 2.0 * piece.Radius * sine * sine * Math.Sign(piece.Sweep); // a counter-clockwise arc is right of its chord
        var middle = MiddleOf(piece) + (new Vector2D(along.Y, -along.X) * (height / 2.0));
        return new SlantedBox(middle, along, length / 2.0, Math.Abs(height) / 2.0);
    }

    /// <summary>Box around several boxes: along the longest of them or upright, whichever is smaller.</summary>
    public static SlantedBox Around(ReadOnlySpan<SlantedBox> boxes)
    {
        var longest = boxes[0];
        foreach (ref readonly var box in boxes)
        {
            if (Math.Max(box.HalfLength, box.HalfWidth) > Math.Max(longest.HalfLength, longest.HalfWidth)) longest = box;
        }

        var (slanted, upright) = (Around(boxes, longest.Along), Around(boxes, s_upright));
        return slanted.Area < upright.Area ? slanted : upright;
    }

    /// <summary>Square of the distance of a point, 0 inside the box.</summary>
    public double SquaredDistance(Point2D place)
    {
        var way = place - Middle;
        var (ahead, beside) = (Math.Max(0.0, Math.Abs(Along.Dot(way)) - HalfLength), Math.Max(0.0, Math.Abs(Along.Cross(way)) - HalfWidth));
        return (ahead * ahead) + (beside * beside);
    }

    /// <summary>True unless a side of either box separates them by more than <paramref name="slack"/>.</summary>
    public bool Overlaps(in SlantedBox other, double slack)
    {
        var way = other.Middle - Middle;
        var (cosine, sine) = (Math.Abs(Along.Dot(other.Along)), Math.Abs(Along.Cross(other.Along)));
        return Math.Abs(Along.Cross(way)) <= HalfWidth + (other.HalfLength * sine) + (other.HalfWidth * cosine) + slack
            && Math.Abs(other.Along.Cross(way)) <= other.HalfWidth + (HalfLength * sine) + (HalfWidth * cosine) + slack
            && Math.Abs(Along.Dot(way)) <= HalfLength + (other.HalfLength * cosine) + (other.HalfWidth * sine) + slack
            && Math.Abs(other.Along.Dot(way)) <= other.HalfLength + (HalfLength * cosine) + (HalfWidth * sine) + slack;
    }

    private static Point2D MiddleOf(in PathPiece piece) => piece.Start + ((piece.End - piece.Start) * 0.5);

    private static SlantedBox Upright(in Bounds2D box) =>
        new(new Point2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0), s_upright, box.Width / 2.0, box.Height / 2.0);

    private static SlantedBox Around(ReadOnlySpan<SlantedBox> boxes, Vector2D along)
    {
        var origin = boxes[0].Middle;
        var (least, most, lowest, highest) = (double.PositiveInfinity, double.NegativeInfinity, double.PositiveInfinity, double.NegativeInfinity);
        foreach (ref readonly var box in boxes)
        {
            var way = box.Middle - origin;
            var (cosine, sine) = (Math.Abs(along.Dot(box.Along)), Math.Abs(along.Cross(box.Along)));
            var (length, width) = ((box.HalfLength * cosine) + (box.HalfWidth * sine), (box.HalfLength * sine) + (box.HalfWidth * cosine));
            (least, most) = (Math.Min(least, along.Dot(way) - length), Math.Max(most, along.Dot(way) + length));
            (lowest, highest) = (Math.Min(lowest, along.Cross(way) - width), Math.Max(highest, along.Cross(way) + width));
        }

        var result = new SlantedBox(origin, along, (most - least) / 2.0, (highest - lowest) / 2.0);
        return result with { Middle = origin + (along * ((least + most) / 2.0)) + (result.Across * ((lowest + highest) / 2.0)) };
    }
}
