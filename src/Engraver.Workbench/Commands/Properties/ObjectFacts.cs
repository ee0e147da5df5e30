using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Commands.Properties;

/// <summary>One object of a drawing, a curve or a text, analysed once for all its properties. Drawing units, plan view.</summary>
internal sealed class ObjectFacts(Drawing drawing, int index)
{
    private Segment[]? _segments;

    public Drawing Drawing => drawing;

    /// <summary>Index into the entities of the shown drawing.</summary>
    public int Index => index;

    public DrawingEntity Entity => ShownDrawing.Of(drawing).Entities[index];

    /// <summary>The text; null for a curve.</summary>
    public PlacedText? Text => ShownDrawing.TextOf(drawing, index) is { } text ? drawing.Texts[text] : null;

    public string Handle => ShownDrawing.Of(drawing).SourceOf(index).Handle ?? "";

    /// <summary>Index of its first part.</summary>
    public int FirstPart => Entity.FirstPart;

    /// <summary>Of a curve; a text has none.</summary>
    public IReadOnlyList<Segment> Segments => _segments ??= Text is null ? [.. DrawingPick.Segments(drawing, index)] : [];

    /// <summary>The line; null for other objects.</summary>
    public LineSegment? Line => Segments is [{ Kind: SegmentKind.Line } only] ? only.Line : null;

    /// <summary>The arc; null for other objects.</summary>
    public ArcSegment? Arc => Segments is [{ Kind: SegmentKind.Arc } only] ? only.Arc : null;

    /// <summary>The circle; null for other objects.</summary>
    public ArcSegment? Circle => Segments is [{ Kind: SegmentKind.Circle } only] ? only.Arc : null;

    public ArcSegment? Round => Arc ?? Circle;

    /// <summary>True if its end is its start.</summary>
    public bool IsClosed => Entity.Closed || (Segments.Count > 0 && (Segments[^1].IsClosed || Segments[0].Start == Segments[^1].End));

    /// <summary>First point of an open curve; null for a closed one.</summary>
    public Point2D? Start => IsClosed || Segments.Count == 0 ? null : Segments[0].Start;

    public Point2D? End => IsClosed || Segments.Count == 0 ? null : Segments[^1].End;

    public double Length => Segments.Sum(segment => segment.Length);

    public bool IsPolyline => Entity.Type is CurveType.LwPolyline or CurveType.Polyline;
}
