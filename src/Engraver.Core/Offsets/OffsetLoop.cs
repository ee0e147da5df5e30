using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets;

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
