using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets;

/// <summary>A contour to be offset: segments in order and direction, each starting near the end of the previous one (gaps are closed in their
/// middle).</summary>
/// <param name="Segments">Lines, arcs, circles, ellipses, splines; an empty list is an empty contour, which has no offset.</param>
/// <param name="Closed">True when the last segment ends where the first starts, except for such a gap.</param>
public sealed record OffsetContour(IReadOnlyList<Segment> Segments, bool Closed);
