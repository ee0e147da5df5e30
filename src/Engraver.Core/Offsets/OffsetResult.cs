using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets;

/// <summary>A contour to be offset: segments in order and direction, each beginning near the end of the one before (gaps are closed in their middle).</summary>
/// <param name="Segments">Lines, arcs, circles, ellipses, splines; none is an empty contour, which has no offset.</param>
/// <param name="Closed">True when the last segment ends where the first begins, but for such a gap.</param>
public sealed record OffsetContour(IReadOnlyList<Segment> Segments, bool Closed);

/// <summary>Where a segment of an offset comes from.</summary>
/// <param name="Contour">Number of the contour among those that were offset.</param>
/// <param name="Segment">Number of the segment within it; of a join the one before the corner in the direction in which the contour was followed.</param>
/// <param name="IsJoin">It goes round the outside of a corner, or round the end of an open contour.</param>
public readonly record struct OffsetSource(int Contour, int Segment, bool IsJoin);

/// <summary>One contour of an offset: lines, arcs and circles, end exactly on start.</summary>
/// <param name="Segments">At least one.</param>
/// <param name="Closed">True when the last segment ends exactly where the first begins; always for the offset of a closed contour.</param>
public sealed record OffsetLoop(IReadOnlyList<Segment> Segments, bool Closed)
{
    /// <summary>What each segment is the offset of; as many as <see cref="Segments"/>.</summary>
    public IReadOnlyList<OffsetSource> Sources { get; init; } = [];

    public int Lines => Segments.Count(segment => segment.Kind == SegmentKind.Line);

    /// <summary>Arcs, whole circles among them.</summary>
    public int Arcs => Segments.Count - Lines;

    public double Length => Segments.Sum(segment => segment.Length);

    /// <summary>Enclosed area in mm2 from the lines and arcs themselves, counter-clockwise positive; 0 when open.</summary>
    public double SignedArea => Closed ? ChainArea.Of(Segments) : 0.0;

    /// <summary>True for a hole in the material: a closed loop that runs clockwise.</summary>
    public bool IsHole => Closed && SignedArea < 0.0;
}

/// <summary>What <see cref="ContourOffset"/> found. Of the material (in, out) outer loops run counter-clockwise and holes clockwise; left and right run as they were drawn.</summary>
/// <param name="Loops">None where nothing is left.</param>
/// <param name="MaxDeviation">Largest difference between the distance asked for and the measured distance of the result from what was drawn, millimetres; corners with a mitre or bevel excepted.</param>
/// <param name="WithoutInside">Open contours that were left out because they have no inside.</param>
/// <param name="Unresolved">Places where the result could not be closed and was left out; none in anything seen so far.</param>
public sealed record OffsetResult(IReadOnlyList<OffsetLoop> Loops, double MaxDeviation, int WithoutInside, IReadOnlyList<Point2D> Unresolved);
