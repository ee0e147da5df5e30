using Engraver.Core.Geometry;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>The polyline being drawn.</summary>
/// <param name="start">Its first point.</param>
/// <param name="direction">Initial direction before the first segment; length 1.</param>
internal sealed class PolylineDraft(Point2D start, Vector2D direction)
{
    private readonly List<Segment> _segments = [];

    public IReadOnlyList<Segment> Segments => _segments;

    public Point2D Start => start;

    public Point2D End => _segments.Count == 0 ? start : _segments[^1].End;

    /// <summary>Direction at the end; length 1.</summary>
    public Vector2D Direction => _segments.Count == 0 ? direction : _segments[^1].EndTangent;

    public bool IsClosed { get; private set; }

    /// <summary>The polyline is finished.</summary>
    public bool IsFinished { get; private set; }

    /// <summary>A line from the end point; null if it has no length.</summary>
    public IReadOnlyList<Segment>? LineTo(Point2D place) => place == End ? null : [Segment.FromLine(End, place)];

    public void Add(Segment segment) => _segments.Add(segment);

    /// <param name="last">Segment from the end to the start; null if they coincide.</param>
    public void Close(IReadOnlyList<Segment>? last)
    {
        if (last is not null) _segments.Add(last[0]);
        (IsClosed, IsFinished) = (true, true);
    }

    public void Finish() => IsFinished = true;

    public void Undo(CommandContext context)
    {
        if (_segments.Count == 0) context.WriteMessage(Wording.Get("Drafting.NothingToUndo"));
        else _segments.RemoveAt(_segments.Count - 1);
    }
}
