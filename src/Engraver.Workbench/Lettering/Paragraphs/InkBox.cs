using Engraver.Fonts;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>The smallest upright rectangle around curves, in their plane. <c>default</c> is not valid; see <see cref="None"/>.</summary>
internal readonly record struct InkBox(double Left, double Bottom, double Right, double Top)
{
    /// <summary>Where there are no curves.</summary>
    public static InkBox None { get; } = new(double.PositiveInfinity, double.PositiveInfinity, double.NegativeInfinity, double.NegativeInfinity);

    public bool IsEmpty => !(Left <= Right);

    public static InkBox Of(GlyphCurves curves)
    {
        var box = None;
        foreach (var contour in curves.Contours)
        {
            var from = contour.Start;
            box = box.With(from);
            foreach (var piece in contour.Pieces)
            {
                box = box.With(piece.End);
                box = piece.Kind switch
                {
                    GlyphPieceKind.Arc => box.WithArc(from, piece),
                    GlyphPieceKind.Quadratic => box.WithQuadratic(from, piece),
                    GlyphPieceKind.Cubic => box.WithCubic(from, piece),
                    _ => box,
                };
                from = piece.End;
            }
        }

        return box;
    }

    /// <summary>Scaled, then moved; both factors are positive.</summary>
    public InkBox Placed(double xFactor, double yFactor, double x, double y) => new((Left * xFactor) + x, (Bottom * yFactor) + y, (Right * xFactor) + x, (Top * yFactor) + y);

    public InkBox With(InkBox other) => new(Math.Min(Left, other.Left), Math.Min(Bottom, other.Bottom), Math.Max(Right, other.Right), Math.Max(Top, other.Top));

    private InkBox With(FontPoint point) => new(Math.Min(Left, point.X), Math.Min(Bottom, point.Y), Math.Max(Right, point.X), Math.Max(Top, point.Y));

    /// <summary>An arc reaches its extremes at its ends and where its circle does, if that point is on the arc.</summary>
    private InkBox WithArc(FontPoint from, in GlyphPiece arc)
    {
        var (x, y) = (arc.End.X - from.X, arc.End.Y - from.Y);
        if (arc.Bulge == 0.0 || (x == 0.0 && y == 0.0)) return this;
        var lift = (1.0 - (arc.Bulge * arc.Bulge)) / (4.0 * arc.Bulge); // from the middle of the chord to the centre, as a multiple of the chord
        var centre = new FontPoint(((from.X + arc.End.X) / 2.0) - (y * lift), ((from.Y + arc.End.Y) / 2.0) + (x * lift));
        var radius = double.Hypot(from.X - centre.X, from.Y - centre.Y);
        var box = this;
        foreach (var (cos, sin) in (ReadOnlySpan<(double, double)>)[(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)])
        {
            var point = new FontPoint(centre.X + (radius * cos), centre.Y + (radius * sin));
            var side = (x * (point.Y - from.Y)) - (y * (point.X - from.X)); // positive on the left of the chord; a counter-clockwise arc is on its right
            if (side * arc.Bulge < 0.0) box = box.With(point);
        }

        return box;
    }

    private InkBox WithQuadratic(FontPoint from, in GlyphPiece piece)
    {
        var box = this;
        if (PeakOf(from.X, piece.Control1.X, piece.End.X) is { } x) box = box.With(new FontPoint(x, piece.End.Y));
        if (PeakOf(from.Y, piece.Control1.Y, piece.End.Y) is { } y) box = box.With(new FontPoint(piece.End.X, y));
        return box;
    }

    /// <summary>The value of a quadratic curve where its slope is zero; null if that is not between its ends.</summary>
    private static double? PeakOf(double start, double control, double end)
    {
        var bend = start - (2.0 * control) + end;
        var at = (start - control) / bend;
        return at is > 0.0 and < 1.0 ? start - ((start - control) * at) : null;
    }

    private InkBox WithCubic(FontPoint from, in GlyphPiece piece)
    {
        var box = this;
        Span<double> peaks = stackalloc double[2];
        foreach (var x in peaks[..PeaksOf(from.X, piece.Control1.X, piece.Control2.X, piece.End.X, peaks)]) box = box.With(new FontPoint(x, piece.End.Y));
        foreach (var y in peaks[..PeaksOf(from.Y, piece.Control1.Y, piece.Control2.Y, piece.End.Y, peaks)]) box = box.With(new FontPoint(piece.End.X, y));
        return box;
    }

    /// <summary>Writes the values of a cubic curve where its slope is zero between its ends; returns their number.</summary>
    private static int PeaksOf(double start, double first, double second, double end, Span<double> peaks)
    {
        var (a, b, c) = (end - start + (3.0 * (first - second)), start - (2.0 * first) + second, first - start); // slope / 3 = a t^2 + 2 b t + c
        var root = Math.Sqrt((b * b) - (a * c));
        var sum = -(b + Math.CopySign(root, b)); // without cancellation
        var count = 0;
        foreach (var at in (ReadOnlySpan<double>)[sum / a, c / sum])
        {
            if (at is not (> 0.0 and < 1.0)) continue;
            var rest = 1.0 - at;
            peaks[count++] = (start * rest * rest * rest) + (3.0 * first * rest * rest * at) + (3.0 * second * rest * at * at) + (end * at * at * at);
        }

        return count;
    }
}
