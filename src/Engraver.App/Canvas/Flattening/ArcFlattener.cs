using Engraver.App.Canvas.Scenes;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Flattening;

/// <summary>An arc as chords that deviate from it by less than <see cref="FlatnessPixels"/> at any scale of the view.</summary>
/// <remarks>The arc is halved until its pieces are flat; pieces outside the view are omitted. The division depends only on the view, not on the clip, so
/// that tiles meet exactly.</remarks>
internal static class ArcFlattener
{
    /// <summary>Largest distance of a chord from its arc, pixels; half of what is visible.</summary>
    public const double FlatnessPixels = 0.12;

    /// <param name="centreX">Pixels.</param>
    /// <param name="centreY">Pixels, y down.</param>
    /// <param name="radius">Pixels.</param>
    /// <param name="span">Angles as in the drawing (y up).</param>
    /// <param name="clip">Pixels; pieces completely outside may be omitted.</param>
    public static void Flatten<TSink>(double centreX, double centreY, double radius, ArcSpan span, in Bounds2D clip, ref TSink sink)
        where TSink : struct, IChordSink
    {
        var halvings = HalvingsFor(radius, span.Sweep);
        var arc = new PixelArc(centreX, centreY, radius, span, 1.0 / (1L << halvings), clip);
        var start = arc.PointAt(0L);
        Divide(arc, 0L, 1L << halvings, start, arc.PointAt(1L << halvings), ref sink);
    }

    /// <summary>The number of halvings of the sweep until the sagitta r (1 - cos(sweep / 2)) of a piece is small enough.</summary>
    private static int HalvingsFor(double radius, double sweep)
    {
        var flat = radius <= FlatnessPixels ? Math.PI / 2.0 : Math.Min(Math.PI / 2.0, 4.0 * Math.Asin(Math.Sqrt(FlatnessPixels / (2.0 * radius))));
        return Math.Clamp((int)Math.Ceiling(Math.Log2(Math.Abs(sweep) / flat)), 0, 48);
    }

    private static void Divide<TSink>(in PixelArc arc, long from, long to, Point2D start, Point2D end, ref TSink sink)
        where TSink : struct, IChordSink
    {
        if (arc.IsHidden(from, to, start, end)) return;
        if (to - from == 1)
        {
            sink.Chord(start.X, start.Y, end.X, end.Y);
            return;
        }

        var middle = from + ((to - from) / 2);
        var place = arc.PointAt(middle);
        Divide(arc, from, middle, start, place, ref sink);
        Divide(arc, middle, to, place, end, ref sink);
    }

    private readonly record struct PixelArc(double CentreX, double CentreY, double Radius, ArcSpan Span, double Step, Bounds2D Clip)
    {
        public Point2D PointAt(long step)
        {
            var (sine, cosine) = Math.SinCos(Span.Start + (Span.Sweep * (step * Step)));
            return new Point2D(CentreX + (Radius * cosine), CentreY - (Radius * sine));
        }

        /// <summary>The piece is inside the box of its ends grown by the sagitta; for more than half a turn only the box of the whole circle is
        /// used.</summary>
        public bool IsHidden(long from, long to, Point2D start, Point2D end)
        {
            var sweep = Math.Abs(Span.Sweep) * ((to - from) * Step);
            if (sweep > Math.PI) return !Overlaps(CentreX - Radius, CentreY - Radius, CentreX + Radius, CentreY + Radius);
            var sine = Math.Sin(sweep / 4.0);
            var reach = (2.0 * Radius * sine * sine) + 1.0;
            return !Overlaps(Math.Min(start.X, end.X) - reach, Math.Min(start.Y, end.Y) - reach, Math.Max(start.X, end.X) + reach, Math.Max(start.Y, end.Y) + reach);
        }

        private bool Overlaps(double minX, double minY, double maxX, double maxY) => minX <= Clip.MaxX && maxX >= Clip.MinX && minY <= Clip.MaxY && maxY >= Clip.MinY;
    }
}
