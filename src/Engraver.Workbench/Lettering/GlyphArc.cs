using Engraver.Fonts;

namespace Engraver.Workbench.Lettering;

/// <summary>An arc of a shape by its bulge, the tangent of a quarter of its sweep, counter-clockwise positive. Font units, radians.</summary>
internal readonly record struct GlyphArc
{
    public GlyphArc(FontPoint from, GlyphPiece piece)
    {
        var (b, dx, dy) = (piece.Bulge, piece.End.X - from.X, piece.End.Y - from.Y);
        var beside = (1.0 - (b * b)) / (4.0 * b);
        Centre = new FontPoint(((from.X + piece.End.X) / 2.0) - (dy * beside), ((from.Y + piece.End.Y) / 2.0) + (dx * beside));
        Radius = Math.Sqrt((dx * dx) + (dy * dy)) * (1.0 + (b * b)) / (4.0 * Math.Abs(b));
        (Start, Sweep) = (Math.Atan2(from.Y - Centre.Y, from.X - Centre.X), 4.0 * Math.Atan(b));
    }

    public FontPoint Centre { get; }

    public double Radius { get; }

    public double Start { get; }

    public double Sweep { get; }

    public FontPoint PointAt(double fraction) => new(Centre.X + (Radius * Math.Cos(Start + (fraction * Sweep))), Centre.Y + (Radius * Math.Sin(Start + (fraction * Sweep))));

    /// <summary>The fraction of the arc at a direction from its centre; above 1 if the arc does not reach it.</summary>
    public double FractionOf(double direction)
    {
        var turn = Math.IEEERemainder(direction - Start, 2.0 * Math.PI) * Math.Sign(Sweep);
        return (turn < 0.0 ? turn + (2.0 * Math.PI) : turn) / Math.Abs(Sweep);
    }
}
