using Engraver.Core;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Motion.Planning;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Collects the segments of consecutive strokes into sequences, plans their speeds, and tracks the controller's predicted position after
/// each.</summary>
/// <param name="planner">For the limits of the machine.</param>
/// <param name="arcs">Has the resolution of angles.</param>
/// <param name="style">With Calls the sequence ends after every segment.</param>
/// <param name="columns">Columns of the whole program; the sequences are appended to them.</param>
internal sealed class SequenceBuilder(SpeedPlanner planner, ArcCommandFit arcs, MotionStyle style, VectorColumns columns)
{
    /// <summary>Counts. The controller may reject a shorter segment (TC 30).</summary>
    private const double ShortestLine = 1.0;

    /// <summary>Step of speeds, counts/s.</summary>
    private const int LastStep = 2;

    private readonly List<VectorSegment> _segments = [];
    private readonly SpeedDivision _division = new(planner, arcs.Quantum);
    private readonly Action<VectorSegment, bool> _add = (segment, _) => columns.Add(segment);
    private CountsPoint _start;

    /// <summary>Where the sequence begins.</summary>
    private CountsPoint _from;
    private double _length;

    /// <summary>The highest feed that is asked of them, counts/s.</summary>
    private double _feed;
    private bool _changesHeight;
    private bool _hasArcs;
    private IReadOnlyList<EntityShare>? _shares;
    private double _along;

    /// <summary>Predicted position: whole counts after VP, the exact end point after CR.</summary>
    public Point2D Position { get; private set; }

    /// <summary>Height of the tool, counts.</summary>
    public int Height { get; private set; }

    /// <summary>Starts a stroke; the previous one must be finished.</summary>
    public void Begin(CountsPoint start)
    {
        _start = start;
        (Position, Height) = (new Point2D(start.X, start.Y), start.Z);
        Clear();
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
        if (FeedLimit.IsNeeded(_segments.Count) && FeedLimit.Of(new ComputedList<double>(_segments.Count, i => _segments[i].Length)) is { } sent) PlanAsSent(sent);
        else planner.Plan();
        Append();
        var end = _segments[^1].End;
        Position = new Point2D(end.X, end.Y);
        Clear();
    }

    /// <summary>The sequence that is slowed most by the time in which segments can be sent; null where none is.</summary>
    public SlowSending? Slowest { get; private set; }

    /// <summary>Number of sequences that are slowed by it.</summary>
    public int SlowSequences { get; private set; }

    private void PlanAsSent(int[] sent)
    {
        for (var i = 0; i < sent.Length; i++)
        {
            if (sent[i] >= planner.FeedOf(i)) sent[i] = int.MaxValue; // it can be sent at its feed
        }

        planner.LimitTo(sent);
        planner.Plan();
        var slowest = default(SlowSending?);
        for (var i = 0; i < sent.Length; i++)
        {
            if (sent[i] == int.MaxValue || planner.SpeedsOf(i).First < sent[i] - LastStep) continue; // the path itself is slower
            if (slowest is null || sent[i] < slowest.Value.Speed) slowest = new SlowSending(sent[i], _feed, _segments[i].EntityIndex);
        }

        if (slowest is not { } found) return;
        SlowSequences++;
        if (Slowest is not { } other || found.Speed / found.Feed < other.Speed / other.Feed) Slowest = found;
    }

    /// <summary>Adds VP, divided equally if it is too long for one. A target less than a count away is not sent.</summary>
    public void Line(CountsPoint target, in PathCourse course)
    {
        if (target.Z != Height && _hasArcs) EndSequence(); // LM takes no arcs (galil-dmc.md B.7)
        var from = Position;
        var way = new Point2D(target.X, target.Y) - from;
        var (rise, length) = ((double)target.Z - Height, double.Hypot(way.Length, (double)target.Z - Height));
        if (length < ShortestLine) return;
        _changesHeight |= target.Z != Height;
        var (pieces, height) = ((int)Math.Ceiling(length / (DmcLimits.LongestSegment - 2.0)), Height);
        for (var i = 1; i < pieces; i++) Piece(CountsScale.Round(from + (way * ((double)i / pieces))) with { Z = height + (int)Math.Round(rise * i / pieces) }, course);
        Piece(target, course);
    }

    /// <summary>Adds CR.</summary>
    public void Arc(ArcPrediction arc, in PathCourse course)
    {
        if (_changesHeight) EndSequence();
        _hasArcs = true;
        var segment = new VectorSegment(VectorSegmentKind.Arc, CountsScale.Round(arc.End) with { Z = Height }, arc.Radius, arc.ThetaDegrees, arc.DeltaDegrees, course.Entity, arc.Length) { Move = course.Move, Moves = course.Moves };
        Add(segment, arc.End, course.Feed, PathDirection.Of(SequenceKinematics.Direction(segment, default, 0.0)), PathDirection.Of(SequenceKinematics.Direction(segment, default, 1.0)));
    }

    private void Piece(CountsPoint target, in PathCourse course)
    {
        var end = new Point2D(target.X, target.Y);
        var length = target.Z == Height ? Position.DistanceTo(end) : double.Hypot(Position.DistanceTo(end), (double)target.Z - Height);
        Add(new VectorSegment(VectorSegmentKind.Line, target, 0, 0.0, 0.0, course.Entity, length) { Move = course.Move, Moves = course.Moves }, end, course.Feed, course.StartDirection, course.EndDirection);
    }

    /// <summary>The segments that follow are of this course.</summary>
    public void BeginCourse(in PathCourse course) => (_shares, _along) = (course.Shares, 0.0);

    private void Add(in VectorSegment segment, Point2D end, double feed, PathDirection start, PathDirection last)
    {
        _segments.Add(SpeedDivision.WithShares(segment, EntityShare.Between(_shares, _along, _along + segment.Length)));
        _along += segment.Length;
        planner.Add(segment.Length, segment.Kind == VectorSegmentKind.Line ? double.PositiveInfinity : segment.Radius, feed, start, last);
        _length += segment.Length;
        _feed = Math.Max(_feed, feed);
        (Position, Height) = (end, segment.End.Z);
        if (style == MotionStyle.Calls || _length + (2.0 * DmcLimits.LongestSegment) > (_changesHeight ? DmcLimits.LongestIncrements : DmcLimits.LongestSequence)) EndSequence();
    }

    /// <summary>The sequence with its planned speeds.</summary>
    private void Append()
    {
        columns.BeginSequence();
        _division.Divide(_segments, _from, _add);
        columns.EndSequence(_division.Fastest, planner.Acceleration, _changesHeight, _changesHeight ? null : (int)_feed, _division.IsUniform);
    }

    private void Clear()
    {
        planner.Clear();
        _segments.Clear();
        (_length, _feed, _changesHeight, _hasArcs) = (0.0, 0.0, false, false);
        _from = CountsScale.Round(Position) with { Z = Height };
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
