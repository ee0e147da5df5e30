using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Oriented boxes round segments. Where curved ones lie closer together than their boxes are wide they are cut into pieces until the boxes are that narrow, and long ones into pieces of like length.</summary>
/// <remarks>The number of boxes is bounded: a few for each segment, and some hundred thousand in all that crowded rings may have more.</remarks>
/// <param name="Boxes">Of all pieces, segment by segment.</param>
/// <param name="Owners">The segment of each.</param>
internal sealed record SegmentBoxes(OrientedBox[] Boxes, int[] Owners)
{
    private const double PiecesPerSegment = 24.0;
    private const double MostPieces = 200_000.0;
    private const double FewPieces = 4096.0;
    private const int MostPiecesOfOne = 4096;

    /// <param name="segments">Ellipses and splines as their pieces (see <see cref="CurvePieces"/>).</param>
    public static SegmentBoxes Of(IReadOnlyList<Segment> segments)
    {
        var (extents, total) = (Bounds2D.Empty, 0.0);
        var sags = new double[segments.Count];
        for (var i = 0; i < sags.Length; i++)
        {
            extents = extents.Union(segments[i].Bounds);
            total += segments[i].Length;
            sags[i] = SagOf(segments[i]);
        }

        var budget = FewPieces + Math.Min(MostPieces, PiecesPerSegment * sags.Length);
        var length = total / budget;
        var width = Math.Max(extents.Width * extents.Height / Math.Max(total, double.Epsilon), double.Epsilon); // what lies between neighbours, if all were spread evenly
        var roots = sags.Sum(sag => Math.Sqrt(sag / width));
        if (roots > budget) width *= roots / budget * (roots / budget);
        var (boxes, owners) = (new List<OrientedBox>(sags.Length), new List<int>(sags.Length));
        for (var i = 0; i < sags.Length; i++) AddPieces(segments[i], i, PiecesOf(segments[i], sags[i], width, length), boxes, owners);
        return new SegmentBoxes([.. boxes], [.. owners]);
    }

    /// <summary>The width of a box falls with the square of the number of pieces.</summary>
    private static int PiecesOf(in Segment segment, double sag, double width, double length)
    {
        var least = segment.Kind is SegmentKind.Arc or SegmentKind.Circle ? Math.Ceiling(Math.Abs(segment.Arc.Sweep.Degrees) / 90.0) : 1.0;
        var wanted = Math.Max(Math.Sqrt(sag / width), length > 0.0 ? segment.Length / length : 1.0);
        return (int)Math.Max(least, Math.Min(MostPiecesOfOne, Math.Ceiling(wanted)));
    }

    /// <summary>Width of the one box round the segment, or round a circle what would shrink like one.</summary>
    private static double SagOf(in Segment segment)
    {
        if (segment.Kind == SegmentKind.Line) return 0.0;
        if (segment.IsFreeCurve) return 2.0 * BoxOf(segment.Curve.Spans[0]).HalfWidth;
        var half = segment.Arc.Sweep.Radians / 2.0;
        return segment.Arc.Radius * half * half / 2.0;
    }

    private static void AddPieces(in Segment segment, int index, int pieces, List<OrientedBox> boxes, List<int> owners)
    {
        for (var piece = 0; piece < pieces; piece++)
        {
            boxes.Add(BoxOf(segment, (double)piece / pieces, (piece + 1.0) / pieces));
            owners.Add(index);
        }
    }

    private static OrientedBox BoxOf(in Segment segment, double from, double to) => segment.IsFreeCurve
        ? BoxOf(segment.Curve.Spans[0].Part(from, to))
        : OrientedBox.Of(SpanDeviation.Part(segment, from, to));

    private static OrientedBox BoxOf(BezierSpan span)
    {
        Span<Point2D> control = stackalloc Point2D[span.Degree + 1];
        for (var i = 0; i < control.Length; i++) control[i] = span.Control(i);
        return OrientedBox.Of(control[0], control[^1], control[1..^1]);
    }
}
