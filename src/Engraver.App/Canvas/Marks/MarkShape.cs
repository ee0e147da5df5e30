using Engraver.App.Canvas.Flattening;
using Engraver.App.Canvas.Scenes;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Marks;

/// <summary>Draws the shape of each kind of mark, in pixels around its point.</summary>
internal static class MarkShape
{
    private const double ArrowLength = 11.0;
    private const double ArrowHead = 4.0;
    private const double DigitScale = 1.25;
    private const double PointArm = 4.0;

    /// <summary>Extent of a mark, pixels from its point in every direction.</summary>
    public static double ReachOf(in SceneMark mark, double scale) => scale * mark.Kind switch
    {
        MarkKind.Order => ArrowLength + 8.0 + (StrokeDigits.WidthOf(mark.Number) * DigitScale),
        MarkKind.Origin => 15.0,
        MarkKind.Finding => 9.0,
        _ => 5.0,
    };

    /// <param name="place">Pixels.</param>
    /// <param name="scale">Pixels of the screen per pixel of the design: 2 on a screen of 200 %.</param>
    public static void Draw<TSink>(in SceneMark mark, Point2D place, double scale, ref TSink sink)
        where TSink : struct, IChordSink
    {
        if (mark.Kind == MarkKind.Order) Order(mark, place, scale, ref sink);
        else if (mark.Kind == MarkKind.Start) Ring(place, 3.0 * scale, ref sink);
        else if (mark.Kind == MarkKind.Finding) Finding(place, scale, ref sink);
        else if (mark.Kind == MarkKind.Point) Cross(place, PointArm * scale, ref sink);
        else Origin(place, scale, ref sink);
    }

    private static void Order<TSink>(in SceneMark mark, Point2D place, double scale, ref TSink sink)
        where TSink : struct, IChordSink
    {
        if (mark.Direction != default) Arrow(place, new Vector2D(mark.Direction.X, -mark.Direction.Y), scale, ref sink);
        var (x, y, size) = (place.X + (6.0 * scale), place.Y - ((4.0 + (StrokeDigits.Height * DigitScale)) * scale), DigitScale * scale);
        var divisor = (int)Math.Pow(10.0, StrokeDigits.CountOf(mark.Number) - 1);
        for (; divisor > 0; divisor /= 10, x += StrokeDigits.Advance * size)
        {
            foreach (var piece in StrokeDigits.Pieces(mark.Number / divisor % 10))
            {
                sink.Chord(x + (piece.FromX * size), y + (piece.FromY * size), x + (piece.ToX * size), y + (piece.ToY * size));
            }
        }
    }

    private static void Arrow<TSink>(Point2D from, Vector2D direction, double scale, ref TSink sink)
        where TSink : struct, IChordSink
    {
        var tip = from + (direction * (ArrowLength * scale));
        var (back, side) = (direction * (-ArrowHead * scale), new Vector2D(-direction.Y, direction.X) * (ArrowHead * 0.6 * scale));
        Line(from, tip, ref sink);
        Line(tip, tip + back + side, ref sink);
        Line(tip, tip + back - side, ref sink);
    }

    private static void Finding<TSink>(Point2D place, double scale, ref TSink sink)
        where TSink : struct, IChordSink
    {
        Ring(place, 7.0 * scale, ref sink);
        Cross(place, 3.5 * scale, ref sink);
    }

    private static void Cross<TSink>(Point2D place, double arm, ref TSink sink)
        where TSink : struct, IChordSink
    {
        Line(place + new Vector2D(-arm, -arm), place + new Vector2D(arm, arm), ref sink);
        Line(place + new Vector2D(-arm, arm), place + new Vector2D(arm, -arm), ref sink);
    }

    private static void Origin<TSink>(Point2D place, double scale, ref TSink sink)
        where TSink : struct, IChordSink
    {
        Ring(place, 7.0 * scale, ref sink);
        var arm = 14.0 * scale;
        Line(place - new Vector2D(arm, 0.0), place + new Vector2D(arm, 0.0), ref sink);
        Line(place - new Vector2D(0.0, arm), place + new Vector2D(0.0, arm), ref sink);
    }

    private static void Ring<TSink>(Point2D place, double radius, ref TSink sink)
        where TSink : struct, IChordSink =>
        ArcFlattener.Flatten(place.X, place.Y, radius, new ArcSpan(0.0, 2.0 * Math.PI), new Bounds2D(double.MinValue, double.MinValue, double.MaxValue, double.MaxValue), ref sink);

    private static void Line<TSink>(Point2D from, Point2D to, ref TSink sink)
        where TSink : struct, IChordSink => sink.Chord(from.X, from.Y, to.X, to.Y);
}
