using System.Runtime.InteropServices;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Merges consecutive courses of a stroke: lines on one line, arcs on one circle, and chords that draw a curve, which become tangent arcs
/// (<see cref="ChordArcs"/>). Arcs and corners of the drawing stay.</summary>
/// <param name="tolerance">Largest distance between chords and arcs, counts.</param>
/// <param name="emit">Receives the courses in order.</param>
internal sealed class CourseMerge(double tolerance, Action<PathCourse> emit)
{
    /// <summary>Part of the tolerance within which courses meet.</summary>
    private const double GapShare = 0.05;

    /// <summary>Times the tolerance over the longer of two chords: the largest turn between chords of one arc.</summary>
    private const double SmoothTurn = 16.0;

    /// <summary>Times the tolerance over a chord: the largest angle between it and an arc through both of its ends.</summary>
    private const double TangentTurn = 4.0;

    /// <summary>Allowance for coordinates that are rounded in the file.</summary>
    private const double RoundingShare = 1.5;

    private const double LargestSweepDegrees = 350.0;

    private readonly ChordArcs _arcs = new((1.0 - GapShare) * tolerance, DmcLimits.SmallestRadius, DmcLimits.LargestRadius);

    /// <summary>The chords that wait; the ends of their courses, one more.</summary>
    private readonly List<Chord> _chords = [];
    private readonly List<Point2D> _vertices = [];

    /// <summary>The first of them.</summary>
    private PathCourse _first;

    /// <summary>An arc that waits for others on its circle.</summary>
    private PathCourse? _arc;

    /// <summary>Where the last emitted course ends, with its direction.</summary>
    private (Point2D Place, Vector2D Direction)? _reached;

    /// <summary>Begins a stroke.</summary>
    public void Clear()
    {
        _chords.Clear();
        _vertices.Clear();
        (_arc, _reached) = (null, null);
    }

    /// <summary>A course that may be merged with those beside it; it is level.</summary>
    public void Add(in PathCourse course)
    {
        if (course.IsLine) AddChord(course);
        else AddArc(course);
    }

    /// <summary>A course that stays as it is.</summary>
    public void Pass(in PathCourse course)
    {
        Flush();
        Emit(course);
    }

    /// <summary>Nothing after this is merged with what is before.</summary>
    public void Flush()
    {
        FlushArc();
        FlushChords(null);
    }

    private void AddArc(in PathCourse course)
    {
        FlushChords(Continued(course));
        if (_arc is { } before && Joined(before, course) is { } whole)
        {
            _arc = whole;
            return;
        }

        FlushArc();
        _arc = course;
    }

    private void AddChord(in PathCourse course)
    {
        FlushArc();
        if (!(course.Shape.Length > 0.0)) return;
        if (_chords.Count > 0 && !IsSmooth(course)) FlushChords(Continued(course));
        if (_chords.Count == 0)
        {
            _first = course;
            _vertices.Add(course.Shape.Start);
        }

        _chords.Add(new Chord(course.Entity, course.Move, course.Shape.Length));
        _vertices.Add(course.Shape.End);
    }

    private bool Meet(Point2D end, Point2D start) => end.DistanceTo(start) <= GapShare * tolerance;

    /// <summary>The chord may continue the curve of those that wait.</summary>
    private bool IsSmooth(in PathCourse next) =>
        Meet(_vertices[^1], next.Shape.Start) && _first.EndZ == next.StartZ && Turn(LastDirection, next.Shape.StartTangent) <= RoundingShare * SmoothTurn * tolerance / Math.Max(_chords[^1].Length, next.Shape.Length);

    private Vector2D LastDirection => Segment.FromLine(_vertices[^2], _vertices[^1]).EndTangent;

    /// <summary>Radians.</summary>
    private static double Turn(Vector2D before, Vector2D after) => before.TurnTo(after).Abs().Radians;

    /// <summary>The direction of the next course, where the chords that wait must continue in it: it is an arc or a longer line, and no corner.</summary>
    private Vector2D? Continued(in PathCourse next)
    {
        if (_chords.Count == 0 || !Meet(_vertices[^1], next.Shape.Start)) return null;
        if (next.IsLine && next.Shape.Length < _chords[^1].Length) return null;
        return IsTangent(_chords[^1].Length, LastDirection, next.Shape.StartTangent) ? next.Shape.StartTangent : null;
    }

    /// <param name="length">Of a chord.</param>
    private bool IsTangent(double length, Vector2D before, Vector2D after) => Turn(before, after) <= RoundingShare * TangentTurn * tolerance / length;

    private void FlushArc()
    {
        if (_arc is { } arc) Emit(arc);
        _arc = null;
    }

    /// <param name="arriving">Direction in which the path continues; null for a corner.</param>
    private void FlushChords(Vector2D? arriving)
    {
        if (_chords.Count == 1)
        {
            Emit(_first);
        }
        else if (_chords.Count > 1)
        {
            var first = _first.Shape;
            var leaving = _reached is { } reached && Meet(reached.Place, first.Start) && IsTangent(first.Length, reached.Direction, first.StartTangent) ? reached.Direction : default(Vector2D?);
            foreach (var arc in _arcs.Cover(CollectionsMarshal.AsSpan(_vertices), leaving, arriving)) Emit(Replaced(arc));
        }

        _chords.Clear();
        _vertices.Clear();
    }

    /// <summary>The course of an arc that replaces chords.</summary>
    private PathCourse Replaced(in ChordArc arc)
    {
        var (first, last) = (_chords[arc.From], _chords[arc.To - 1]);
        var shares = new List<EntityShare>();
        for (var i = arc.From; i < arc.To; i++)
        {
            var part = _chords[i];
            if (shares.Count > 0 && shares[^1].EntityIndex == part.Entity) shares[^1] = shares[^1] with { Length = shares[^1].Length + part.Length };
            else shares.Add(new EntityShare(part.Entity, part.Length));
        }

        return _first with
        {
            Shape = arc.Arc.ToSegment(),
            Entity = first.Entity,
            Move = first.Move,
            Moves = last.Move + 1 - first.Move,
            Shares = shares.Count > 1 ? shares : null,
            StartPart = first.Length,
            EndPart = last.Length,
        };
    }

    /// <summary>Two arcs as one; null where they are not on one circle, or would be a whole turn.</summary>
    private PathCourse? Joined(in PathCourse before, in PathCourse after)
    {
        var (a, b) = (before.Shape.Arc, after.Shape.Arc);
        var within = GapShare * tolerance;
        if (Math.Abs(a.Radius - b.Radius) > within || a.Centre.DistanceTo(b.Centre) > within || !Meet(before.Shape.End, after.Shape.Start) || a.Sweep.Degrees * b.Sweep.Degrees <= 0.0) return null;
        var sweep = a.Sweep + b.Sweep;
        if (before.StartZ != after.StartZ || sweep.Abs().Degrees > LargestSweepDegrees) return null;
        List<EntityShare> shares = [.. before.Shares ?? [new EntityShare(before.Entity, before.Length)]];
        if (shares[^1].EntityIndex == after.Entity) shares[^1] = shares[^1] with { Length = shares[^1].Length + after.Length };
        else shares.Add(new EntityShare(after.Entity, after.Length));
        return before with
        {
            Shape = Segment.FromArc(a with { Sweep = sweep }, before.Shape.Start, after.Shape.End),
            Moves = after.Move + 1 - before.Move,
            Shares = shares.Count > 1 ? shares : null,
            StartPart = Math.Min(before.StartPart, before.Length),
            EndPart = after.Length,
        };
    }

    private void Emit(in PathCourse course)
    {
        _reached = (course.Shape.End, course.Shape.EndTangent);
        emit(course);
    }

    /// <summary>A line of the toolpath.</summary>
    /// <param name="Entity">Drawing entity.</param>
    /// <param name="Move">Index in the toolpath's stroke.</param>
    /// <param name="Length">Counts.</param>
    private readonly record struct Chord(int Entity, int Move, double Length);
}
