using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Oriented boxes around segments. Curved segments that are closer together than the width of their boxes are cut into pieces until the boxes are
/// narrower, and long segments into pieces of similar length.</summary>
/// <remarks>The number of boxes is bounded: a few for each segment, and some hundred thousand in total as a reserve for crowded rings.</remarks>
/// <param name="Boxes">Boxes of all pieces, segment by segment.</param>
/// <param name="Owners">The segment of each.</param>
/// <param name="Parts">The part of the segment, as fractions; for a curve of many spans, the whole curve.</param>
internal sealed record SegmentBoxes(OrientedBox[] Boxes, int[] Owners, (double From, double To)[] Parts)
{
    private const double PiecesPerSegment = 24.0;
    private const double MaxPieces = 200_000.0;
    private const double FewPieces = 4096.0;
    private const int MaxPiecesOfOne = 4096;

    /// <summary>Largest width of a box, as a fraction of the distance between neighbours if all were spread evenly over the drawing. Most of a drawing is
    /// empty.</summary>
    private const double Narrow = 1.0 / 16.0;

    public static SegmentBoxes From(IReadOnlyList<Segment> segments) => From(segments, FewPieces + Math.Min(MaxPieces, PiecesPerSegment * segments.Count));

    /// <param name="segments">See <see cref="SegmentIndex"/>.</param>
    /// <param name="budget">Approximate number of boxes; more when the segments need more.</param>
    public static SegmentBoxes From(IReadOnlyList<Segment> segments, double budget)
    {
        var (extents, total) = (Bounds2D.Empty, 0.0);
        var sags = new double[segments.Count];
        for (var i = 0; i < sags.Length; i++)
        {
            extents = extents.Union(segments[i].Bounds);
            total += segments[i].Length;
            sags[i] = SagOf(segments[i]);
        }

        var length = total / budget;
        var width = Math.Max(Narrow * extents.Width * extents.Height / Math.Max(total, double.Epsilon), double.Epsilon);
        var roots = sags.Sum(sag => Math.Sqrt(sag / width));
        if (roots > budget) width *= roots / budget * (roots / budget);
        var (boxes, owners, parts) = (new List<OrientedBox>(sags.Length), new List<int>(sags.Length), new List<(double From, double To)>(sags.Length));
        for (var i = 0; i < sags.Length; i++)
        {
            AddPieces(segments[i], PiecesOf(segments[i], sags[i], width, length), boxes, parts);
            while (owners.Count < boxes.Count) owners.Add(i);
        }

        return new SegmentBoxes([.. boxes], [.. owners], [.. parts]);
    }

    /// <summary>The width of a box falls with the square of the number of pieces.</summary>
    private static int PiecesOf(in Segment segment, double sag, double width, double length)
    {
        var least = segment.Kind is SegmentKind.Arc or SegmentKind.Circle ? Math.Ceiling(Math.Abs(segment.Arc.Sweep.Degrees) / 90.0) : 1.0;
        var wanted = Math.Max(Math.Sqrt(sag / width), length > 0.0 ? segment.Length / length : 1.0);
        return (int)Math.Max(least, Math.Min(MaxPiecesOfOne, Math.Ceiling(wanted)));
    }

    /// <summary>Width of the box round the segment (of a curve, round its widest span), or for a circle, the equivalent width that shrinks in the same
    /// way.</summary>
    private static double SagOf(in Segment segment)
    {
        if (segment.Kind == SegmentKind.Line) return 0.0;
        if (segment.IsFreeCurve) return segment.Curve.Spans.ToArray().Max(span => 2.0 * OrientedBox.Around(span).HalfWidth);
        var half = segment.Arc.Sweep.Radians / 2.0;
        return segment.Arc.Radius * half * half / 2.0;
    }

    private static void AddPieces(in Segment segment, int pieces, List<OrientedBox> boxes, List<(double From, double To)> parts)
    {
        var spans = segment.IsFreeCurve ? segment.Curve.Spans : [];
        for (var span = 0; span < Math.Max(1, spans.Length); span++)
        {
            for (var piece = 0; piece < pieces; piece++)
            {
                var (from, to) = ((double)piece / pieces, (piece + 1.0) / pieces);
                parts.Add(spans.Length > 1 ? (0.0, 1.0) : (from, to));
                boxes.Add(spans.Length > 0 ? OrientedBox.Around(spans[span].Part(from, to)) : OrientedBox.Around(SegmentPart.Of(segment, from, to)));
            }
        }
    }
}
