using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets;

/// <summary>A contour to be offset: segments in order and direction, each starting near the end of the previous one (gaps are closed in their
/// middle).</summary>
/// <param name="Segments">Lines, arcs, circles, ellipses, splines; an empty list is an empty contour, which has no offset.</param>
/// <param name="Closed">True when the last segment ends where the first starts, except for such a gap.</param>
public sealed record OffsetContour(IReadOnlyList<Segment> Segments, bool Closed);

/// <summary>Source of a segment of an offset.</summary>
/// <param name="Contour">Number of the contour among those that were offset.</param>
/// <param name="Segment">Number of the segment within it; for a join, the segment before the corner in the direction in which the contour was followed.</param>
/// <param name="IsJoin">True when it runs around the outside of a corner or around the end of an open contour.</param>
public readonly record struct OffsetSource(int Contour, int Segment, bool IsJoin);

/// <summary>One contour of an offset: lines, arcs and circles, each end exactly at the next start.</summary>
/// <param name="Segments">Segments, at least one.</param>
/// <param name="Closed">True when the last segment ends exactly where the first begins; always for the offset of a closed contour.</param>
public sealed record OffsetLoop(IReadOnlyList<Segment> Segments, bool Closed)
{
    /// <summary>Source of each segment; as many as <see cref="Segments"/>.</summary>
    public IReadOnlyList<OffsetSource> Sources { get; init; } = [];

    public int Lines => Segments.Count(segment => segment.Kind == SegmentKind.Line);

    /// <summary>Number of arcs, including full circles.</summary>
    public int Arcs => Segments.Count - Lines;

    public double Length => Segments.Sum(segment => segment.Length);

    /// <summary>Enclosed area in mm2 from the lines and arcs themselves, counter-clockwise positive; 0 when open.</summary>
    public double SignedArea => Closed ? ChainArea.Of(Segments) : 0.0;

    /// <summary>True for a hole in the material: a closed loop that runs clockwise.</summary>
    public bool IsHole => Closed && SignedArea < 0.0;
}

/// <summary>The result of <see cref="ContourOffset"/>. For the material (in, out), outer loops run counter-clockwise and holes clockwise; left and right
/// offsets run in the drawn direction.</summary>
/// <param name="Loops">Empty when nothing remains.</param>
/// <param name="MaxDeviation">Largest difference between the requested distance and the measured distance of the result from the drawn contours, millimetres;
/// corners with a mitre or bevel are excluded.</param>
/// <param name="WithoutInside">Number of open contours that were left out because they have no inside.</param>
/// <param name="Unresolved">Points where the result could not be closed and was left out; none in any drawing tested so far.</param>
public sealed record OffsetResult(IReadOnlyList<OffsetLoop> Loops, double MaxDeviation, int WithoutInside, IReadOnlyList<Point2D> Unresolved);
