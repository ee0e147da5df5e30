using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Collects the segments of one stroke into sequences and tracks the controller's predicted position after each.</summary>
/// <param name="start">Where the stroke begins.</param>
/// <param name="wantedSpeed">VS, unless a sequence needs a lower one.</param>
/// <param name="style">With Calls the sequence ends after every segment.</param>
internal sealed class SequenceBuilder(CountsPoint start, int wantedSpeed, MotionStyle style)
{
    /// <summary>Counts. The controller may refuse a shorter segment (TC 30).</summary>
    private const double ShortestLine = 1.0;

    private readonly List<VectorSequence> _finished = [];
    private List<VectorSegment> _segments = [];
    private CountsPoint _start = start;
    private double _length;

    /// <summary>Predicted position: whole counts after VP, the real end point after CR.</summary>
    public Point2D Position { get; private set; } = new(start.X, start.Y);

    /// <summary>The stroke's sequences; none when everything was shorter than a count.</summary>
    public IReadOnlyList<VectorSequence> Finish()
    {
        EndSequence();
        return _finished;
    }

    /// <summary>VE: the machine stops here, and the next sequence begins at whole counts.</summary>
    public void EndSequence()
    {
        if (_segments.Count == 0) return;
        _finished.Add(new VectorSequence(_start, FeedLimit.For(_segments, wantedSpeed), _segments));
        _start = _segments[^1].End;
        Position = new Point2D(_start.X, _start.Y);
        _segments = [];
        _length = 0.0;
    }

    /// <summary>Adds VP, in equal pieces when it is too long for one. A target less than a count away is not sent.</summary>
    public void Line(CountsPoint target, int entity)
    {
        var from = Position;
        var way = new Point2D(target.X, target.Y) - from;
        if (way.Length < ShortestLine) return;
        var pieces = (int)Math.Ceiling(way.Length / (DmcLimits.LongestSegment - 2.0));
        for (var i = 1; i < pieces; i++) Piece(CountsScale.Round(from + (way * ((double)i / pieces))), entity);
        Piece(target, entity);
    }

    /// <summary>Adds CR.</summary>
    public void Arc(ArcPrediction arc, int entity)
    {
        Add(new VectorSegment(VectorSegmentKind.Arc, CountsScale.Round(arc.End), arc.Radius, arc.ThetaDegrees, arc.DeltaDegrees, entity, arc.Length), arc.End);
    }

    private void Piece(CountsPoint target, int entity)
    {
        var end = new Point2D(target.X, target.Y);
        Add(new VectorSegment(VectorSegmentKind.Line, target, 0, 0.0, 0.0, entity, Position.DistanceTo(end)), end);
    }

    private void Add(in VectorSegment segment, Point2D end)
    {
        _segments.Add(segment);
        _length += segment.Length;
        Position = end;
        if (style == MotionStyle.Calls || _length + (2.0 * DmcLimits.LongestSegment) > DmcLimits.LongestSequence) EndSequence();
    }
}
