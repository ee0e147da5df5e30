using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Motion.Planning;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Converts strokes to vector sequences, one after the other.</summary>
/// <remarks>The moves of a stroke become courses in exact counts; corners are rounded between courses, and each course is cut as soon as the arcs at both of
/// its ends are known.</remarks>
internal sealed class StrokeGenerator
{
    /// <summary>Maximum number of halvings of an arc before it is cut as chords.</summary>
    private const int MaxHalvings = 8;

    private const double ShortestPiece = 8.0;

    private const double StopDegrees = 10.0;

    /// <summary>An arc at a corner is this much faster than the corner without it.</summary>
    private const double LeastGain = 1.05;

    /// <summary>Allowance, so that a turn of exactly the limit does not depend on the last bit.</summary>
    private const double RoundingDegrees = 1e-6;

    /// <summary>What is left of an arc between two corners is not cut where it is shorter, counts.</summary>
    private const double ShortestCourse = 1.0;

    private readonly CountsScale _scale;
    private readonly double _maxErrorMm;
    private readonly double _cornerTolerance;
    private readonly ArcCommandFit _arcFit;
    private readonly SequenceBuilder _builder;
    private readonly CourseMerge? _merge;
    private readonly MachineProfile _profile;
    private readonly MotionStyle _style;
    private readonly PathLimits _limits;
    private readonly SlopeSpeed _slope;
    private readonly bool _stopsAtCorners;
    private readonly List<PathCourse> _waiting = [];
    private bool _isRounding;
    private bool _isInsideRow;

    /// <summary>The move is a row of the drawing, and not a piece of a curve that was replaced.</summary>
    private bool _isMergeable;
    private double _lift;
    private double _trimmed;
    private CountsPoint _reached;
    private Point2D _reachedExactly;
    private Point2D _cutTo;
    private PathCourse _course;

    /// <param name="profile">The machine.</param>
    /// <param name="tolerances">How far the motion may be beside the toolpath.</param>
    /// <param name="style">How segments are grouped.</param>
    /// <param name="columns">Columns of the whole program; the strokes are appended to them.</param>
    public StrokeGenerator(MachineProfile profile, MotionTolerances tolerances, MotionStyle style, VectorColumns columns)
    {
        (_profile, _style) = (profile, style);
        _scale = profile.Scale;
        _maxErrorMm = ArcChords.ErrorOf(tolerances.MaxErrorMm, _scale);
        _cornerTolerance = _scale.IsUniform ? _scale.Finer.CountsOf(tolerances.CornerMm) : 0.0;
        _arcFit = new ArcCommandFit(new AngleQuantum(profile.AngleQuantumDegrees));
        _limits = PathLimits.Of(profile);
        _slope = new SlopeSpeed(profile);
        _stopsAtCorners = tolerances.CornerMm == 0.0;
        if (tolerances.FitsArcs && _scale.IsUniform) _merge = new CourseMerge(_scale.Finer.CountsOf(_maxErrorMm), Append);
        _builder = new SequenceBuilder(new SpeedPlanner(_limits, DmcLimits.AccelerationStep), _arcFit, style, columns);
    }

    /// <summary>As <see cref="SequenceBuilder.Slowest"/>.</summary>
    public SlowSending? Slowest => _builder.Slowest;

    /// <summary>As <see cref="SequenceBuilder.SlowSequences"/>.</summary>
    public int SlowSequences => _builder.SlowSequences;

    /// <summary>Appends a pass of the stroke, in counts.</summary>
    /// <param name="lift">Height of the pass above the depth of the stroke, millimetres; 0 for the last pass, and for a machine without a tool axis.</param>
    /// <param name="terms">How the tool is brought to the work and taken away.</param>
    /// <returns>False when the whole stroke is shorter than a count: nothing is appended.</returns>
    public bool Generate(ToolpathStroke stroke, double lift, StrokeTerms? terms)
    {
        var first = stroke.Moves[0];
        _lift = lift;
        _isRounding = _cornerTolerance > 0.0 && _style != MotionStyle.Calls && (_profile.Height is null || stroke.Moves.All(move => move.StartZ == move.EndZ));
        _reached = Place(first.Segment.Start, first.StartZ);
        _reachedExactly = _scale.Exact(first.Segment.Start);
        _cutTo = new Point2D(_reached.X, _reached.Y);
        _waiting.Clear();
        _merge?.Clear();
        _trimmed = 0.0;
        _builder.Begin(_reached);
        var (row, ofRow) = (0, 0);
        for (var i = 0; i < stroke.Moves.Count; i++)
        {
            var movesOfRow = row < stroke.RowMoves?.Count ? stroke.RowMoves[row] : 1;
            (_isInsideRow, _isMergeable) = (ofRow > 0, movesOfRow == 1);
            if (i > 0 && stroke.Moves[i].Role != stroke.Moves[i - 1].Role) _merge?.Flush();
            Move(stroke.Moves[i], i);
            if (++ofRow >= movesOfRow) (row, ofRow) = (row + 1, 0);
        }

        _merge?.Flush();

        while (_waiting.Count > 0) CutFirst();
        return _builder.Finish(stroke.Index, terms);
    }

    private void Move(in StrokeMove move, int index)
    {
        var segment = move.Segment;
        var (from, to) = (Place(segment.Start, move.StartZ), Place(segment.End, move.EndZ));
        if (Vanishes(segment) && to.Z == _reached.Z) return;
        var start = _scale.Exact(segment.Start);
        if (from != _reached) Add(new PathCourse(Segment.FromLine(_reachedExactly, start), _reached.Z, from.Z, move.EntityIndex, index, 0.0)); // a gap within the join tolerance
        var end = _scale.Exact(segment.End);
        if (segment.Kind == SegmentKind.Line)
        {
            Add(new PathCourse(Segment.FromLine(start, end), from.Z, to.Z, move.EntityIndex, index, 0.0));
        }
        else if (_scale.IsUniform && ArcCommandFit.CanHold(_scale.Exact(segment.Arc).Radius))
        {
            Add(new PathCourse(Segment.FromArc(_scale.Exact(segment.Arc), start, end), from.Z, to.Z, move.EntityIndex, index, 0.0));
        }
        else
        {
            foreach (var vertex in ArcChords.Vertices(segment.Arc, _maxErrorMm).Select(_scale.Exact))
            {
                Add(new PathCourse(Segment.FromLine(start, vertex), from.Z, from.Z, move.EntityIndex, index, 0.0));
                (start, _isInsideRow) = (vertex, true);
            }

            _isInsideRow = false;
        }

        (_reached, _reachedExactly) = (to, end);
        _cutTo = segment.Kind == SegmentKind.Line ? new Point2D(to.X, to.Y) : end;
    }

    private CountsPoint Place(Point2D millimetres, double z) => _scale.ToCounts(millimetres) with { Z = HeightOf(z, _profile, _lift) };

    /// <summary>The height at which the tool axis cuts, below the drawn height; on other machines heights are not cut.</summary>
    private static int HeightOf(double drawn, MachineProfile profile, double lift) => profile.Height is { } drive ? profile.Scale.ToHeight(drawn - drive.CutDepth + lift) : 0;

    /// <summary>True when the move is shorter than a count and does not add up to a count together with the previous ones.</summary>
    private bool Vanishes(in Segment segment) =>
        _scale.Finer.CountsOf(segment.Length) < 1.0 && _cutTo.DistanceTo(_scale.Exact(segment.End)) < 1.0;

    private void Add(in PathCourse course)
    {
        var next = course with { ContinuesCurve = _isInsideRow };
        _isInsideRow = false;
        if (_merge is null) Append(next);
        else if (_isMergeable && next is { IsLevel: true, ContinuesCurve: false, Shape.IsClosed: false }) _merge.Add(next);
        else _merge.Pass(next);
    }

    private void Append(PathCourse course)
    {
        var feed = course.IsLevel ? _profile.VectorSpeed() : _slope.Of(course.Shape.End - course.Shape.Start, course.EndZ - course.StartZ);
        var next = course with { Feed = feed };
        if (_waiting.Count > 0 && _stopsAtCorners && _style != MotionStyle.Calls && IsSharp(_waiting[^1], next) && IsCorner(_waiting[^1], next)) next = next with { IsAfterStop = true };
        _waiting.Add(next);
        if (_waiting.Count > 2) CutFirst();
    }

    /// <summary>The path turns too sharply between two courses to be run at their speed.</summary>
    private bool IsCorner(in PathCourse before, in PathCourse after) => SpeedThrough(before, after) < Math.Min(before.Feed, after.Feed);

    private double SpeedThrough(in PathCourse before, in PathCourse after) => _limits.SpeedThrough(_limits.TurnOf(before.EndDirection, after.StartDirection), Math.Min(before.Length, after.Length));

    /// <summary>The machine stops at such a turn if corners are not rounded; a smaller one is passed as slowly as the acceleration requires.</summary>
    private static bool IsSharp(in PathCourse before, in PathCourse after) => before.EndDirection.TurnTo(after.StartDirection) > StopDegrees + RoundingDegrees;

    /// <summary>Cuts the first course that waits, and the arc at the corner after it.</summary>
    private void CutFirst()
    {
        var course = _waiting[0];
        var corner = CornerAfter(0, _waiting.Count > 2 ? LengthWantedAfter(1) : 0.0);
        Cut(course.Trimmed(_trimmed, corner?.Before ?? 0.0));
        _trimmed = corner?.After ?? 0.0;
        _waiting.RemoveAt(0);
        if (corner is { } rounding) Cut(new PathCourse(Segment.FromArc(rounding.Arc), course.EndZ, course.EndZ, _waiting[0].Entity, _waiting[0].Move, Math.Min(course.Feed, _waiting[0].Feed)));
    }

    /// <summary>The arc between two courses that wait; null where there is none.</summary>
    /// <param name="index">Of the first of them.</param>
    /// <param name="wantedByNext">Length of the second one that the arc at its other end would replace.</param>
    private CornerArc? CornerAfter(int index, double wantedByNext)
    {
        if (!IsRounded(index)) return null;
        var (before, after) = (_waiting[index], _waiting[index + 1]);
        var whole = Largest(before, after, (before.Length - _trimmed, after.Length));
        if (whole is not { } wanted || wanted.After + wantedByNext <= after.Length) return whole;
        var share = wantedByNext <= 0.0 ? 1.0 : Math.Max(wanted.After / (wanted.After + wantedByNext), 1.0 - (wantedByNext / after.Length));
        return Largest(before, after, (before.Length - _trimmed, after.Length * share));
    }

    /// <summary>Length of the first of two courses that the arc between them would replace.</summary>
    private double LengthWantedAfter(int index) => IsRounded(index) && Largest(_waiting[index], _waiting[index + 1], (_waiting[index].Length, _waiting[index + 1].Length)) is { } arc ? arc.Before : 0.0;

    private bool IsRounded(int index) => _isRounding && index + 1 < _waiting.Count && !_waiting[index + 1].ContinuesCurve && IsCorner(_waiting[index], _waiting[index + 1]);

    /// <summary>The arc, where it is faster than the corner: chords of a curve are as fast without one.</summary>
    private CornerArc? Largest(in PathCourse before, in PathCourse after, (double Before, double After) most) =>
        CornerArc.Largest(before, after, _cornerTolerance, (Math.Min(most.Before, before.EndPart), Math.Min(most.After, after.StartPart)), DmcLimits.SmallestRadius, DmcLimits.LargestRadius) is { } arc && Math.Sqrt(_limits.OnArcs * arc.Arc.Radius) > LeastGain * SpeedThrough(before, after) ? arc : null;

    private void Cut(in PathCourse course)
    {
        _course = course;
        _builder.BeginCourse(course);
        if (course.IsAfterStop) _builder.EndSequence();
        if (course.IsLine) _builder.Line(CountsScale.Round(course.Shape.End) with { Z = course.EndZ }, course);
        else if (course.Length >= ShortestCourse) LastPiece(course.Shape.Arc, course.Shape.End, MaxHalvings);
    }

    /// <summary>The piece that ends at the end of the move: one CR; otherwise the arc is halved, and its second half is processed in the same way.</summary>
    private void LastPiece(ArcSegment wanted, Point2D trueEnd, int halvings)
    {
        var target = CountsScale.Round(trueEnd);
        if (_arcFit.ToEnd(_builder.Position, wanted, new Point2D(target.X, target.Y), trueEnd) is { } aimed)
        {
            _builder.Arc(aimed, _course);
        }
        else if (CanHalve(wanted, halvings))
        {
            InnerPiece(FirstHalf(wanted), halvings - 1);
            LastPiece(SecondHalf(wanted), trueEnd, halvings - 1);
        }
        else
        {
            Chords(wanted);
        }
    }

    private void InnerPiece(ArcSegment wanted, int halvings)
    {
        if (_arcFit.ToMark(_builder.Position, wanted) is { } aimed)
        {
            _builder.Arc(aimed, _course);
        }
        else if (CanHalve(wanted, halvings))
        {
            InnerPiece(FirstHalf(wanted), halvings - 1);
            InnerPiece(SecondHalf(wanted), halvings - 1);
        }
        else
        {
            Chords(wanted);
        }
    }

    private void Chords(ArcSegment wanted)
    {
        foreach (var vertex in ArcChords.Vertices(wanted, _scale.Finer.CountsOf(_maxErrorMm)))
        {
            _builder.Line(CountsScale.Round(vertex) with { Z = _builder.Height }, _course with { Shape = Segment.FromLine(_builder.Position, vertex) });
        }
    }

    private static bool CanHalve(ArcSegment wanted, int halvings) => halvings > 0 && wanted.Length >= 2.0 * ShortestPiece;

    private static ArcSegment FirstHalf(ArcSegment arc) => arc with { Sweep = arc.Sweep * 0.5 };

    private static ArcSegment SecondHalf(ArcSegment arc) => arc with { Start = arc.Start + (arc.Sweep * 0.5), Sweep = arc.Sweep * 0.5 };
}
