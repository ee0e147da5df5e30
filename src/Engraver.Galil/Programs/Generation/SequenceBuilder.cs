using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Collects the segments of consecutive strokes into sequences and tracks the controller's predicted position after each.</summary>
/// <param name="wantedSpeed">VS in plan, unless a sequence needs a lower one.</param>
/// <param name="slope">Speed of lines that rise or fall.</param>
/// <param name="style">With Calls the sequence ends after every segment.</param>
/// <param name="columns">Columns of the whole program; the sequences are appended to them.</param>
internal sealed class SequenceBuilder(int wantedSpeed, SlopeSpeed slope, MotionStyle style, VectorColumns columns)
{
    /// <summary>Counts. The controller may reject a shorter segment (TC 30).</summary>
    private const double ShortestLine = 1.0;

    private readonly List<VectorSegment> _segments = [];
    private CountsPoint _start;
    private double _length;
    private int _slopeSpeed = int.MaxValue;
    private bool _hasArcs;

    /// <summary>A line of this sequence rises or falls.</summary>
    private bool ChangesHeight => _slopeSpeed < int.MaxValue;

    /// <summary>Predicted position: whole counts after VP, the exact end point after CR.</summary>
    public Point2D Position { get; private set; }

    /// <summary>Height of the tool, counts.</summary>
    public int Height { get; private set; }

    /// <summary>Starts a stroke; the previous one must be finished.</summary>
    public void Begin(CountsPoint start)
    {
        _start = start;
        (Position, Height) = (new Point2D(start.X, start.Y), start.Z);
        (_length, _slopeSpeed, _hasArcs) = (0.0, int.MaxValue, false);
    }

    /// <summary>Appends the stroke.</summary>
    /// <param name="index">Index of the stroke in the toolpath.</param>
    /// <param name="terms">How the tool is brought to the work and taken away.</param>
    /// <returns>False when the whole stroke is shorter than a count: nothing is appended.</returns>
    public bool Finish(int index, StrokeTerms? terms)
    {
        EndSequence();
        return columns.EndStroke(index, _start, terms);
    }

    /// <summary>VE: the machine stops here, and the next sequence starts at whole counts.</summary>
    public void EndSequence()
    {
        if (_segments.Count == 0) return;
        columns.Append(FeedLimit.For(_segments, Math.Min(wantedSpeed, _slopeSpeed)), _segments, ChangesHeight);
        var end = _segments[^1].End;
        Position = new Point2D(end.X, end.Y);
        _segments.Clear();
        (_length, _slopeSpeed, _hasArcs) = (0.0, int.MaxValue, false);
    }

    /// <summary>Adds VP, divided equally if it is too long for one. A target less than a count away is not sent.</summary>
    public void Line(CountsPoint target, int entity)
    {
        if (target.Z != Height && _hasArcs) EndSequence(); // LM takes no arcs (galil-dmc.md B.7)
        var from = Position;
        var way = new Point2D(target.X, target.Y) - from;
        if (target.Z != Height) _slopeSpeed = Math.Min(_slopeSpeed, slope.Of(way, target.Z - Height));
        var (rise, length) = ((double)target.Z - Height, double.Hypot(way.Length, (double)target.Z - Height));
        if (length < ShortestLine) return;
        var (pieces, height) = ((int)Math.Ceiling(length / (DmcLimits.LongestSegment - 2.0)), Height);
        for (var i = 1; i < pieces; i++) Piece(CountsScale.Round(from + (way * ((double)i / pieces))) with { Z = height + (int)Math.Round(rise * i / pieces) }, entity);
        Piece(target, entity);
    }

    /// <summary>Adds CR.</summary>
    public void Arc(ArcPrediction arc, int entity)
    {
        if (ChangesHeight) EndSequence();
        _hasArcs = true;
        Add(new VectorSegment(VectorSegmentKind.Arc, CountsScale.Round(arc.End) with { Z = Height }, arc.Radius, arc.ThetaDegrees, arc.DeltaDegrees, entity, arc.Length), arc.End);
    }

    private void Piece(CountsPoint target, int entity)
    {
        var end = new Point2D(target.X, target.Y);
        Add(new VectorSegment(VectorSegmentKind.Line, target, 0, 0.0, 0.0, entity, target.Z == Height ? Position.DistanceTo(end) : double.Hypot(Position.DistanceTo(end), (double)target.Z - Height)), end);
    }

    private void Add(in VectorSegment segment, Point2D end)
    {
        _segments.Add(segment);
        _length += segment.Length;
        (Position, Height) = (end, segment.End.Z);
        if (style == MotionStyle.Calls || _length + (2.0 * DmcLimits.LongestSegment) > (ChangesHeight ? DmcLimits.LongestIncrements : DmcLimits.LongestSequence)) EndSequence();
    }
}

/// <summary>VS of lines in three axes: the feed along the path in millimetres, independent of the scales of the axes (galil-dmc.md B.5: VS is the root of the
/// sum over all axes of LM), and downwards at most the plunge feed.</summary>
internal readonly record struct SlopeSpeed(MachineProfile Profile)
{
    /// <param name="way">Vector in plan, counts.</param>
    /// <param name="rise">Counts of the Z axis, not 0.</param>
    /// <returns>Even counts/s.</returns>
    public int Of(Vector2D way, int rise)
    {
        var scale = Profile.Scale;
        var up = scale.Z.ToMillimetres(rise);
        var (millimetres, counts) = (double.Hypot(scale.ToMillimetres(way).Length, up), double.Hypot(way.Length, rise));
        var perSecond = Profile.FeedMmPerMinute / 60.0 * counts / millimetres;
        if (up < 0.0 && Profile.Height is { } drive) perSecond = Math.Min(perSecond, drive.PlungeMmPerMinute / 60.0 * counts / -up);
        return Math.Max(DmcLimits.SlowestSpeed, 2 * (int)Math.Floor(Math.Min(perSecond, DmcLimits.FastestSpeed) / 2.0));
    }
}
