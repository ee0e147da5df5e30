using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>One piece of a chain: a line, an arc or circle, or a nearly straight part of an ellipse or spline. Places on it are fractions of its parameter, 0
/// to 1, or lengths from its start.</summary>
internal sealed class ChainPiece
{
    /// <summary>Steps of the table of lengths of a free piece; pieces are nearly straight and of nearly constant speed (<see cref="CurvePieces"/>).</summary>
    private const int TableSteps = 8;

    /// <summary>Allowed distance of a control point of a straight curve from its chord, millimetres: only rounding.</summary>
    private const double StraightWithin = 1e-9;

    private const int MaxNewtonSteps = 8;

    private const int MaxLengthSteps = 60;

    /// <summary>Accuracy, as a fraction of its length, of a place on a free piece found by <see cref="FractionAtArcLength"/>.</summary>
    private const double LengthShare = 1e-13;

    private readonly Segment _segment;
    private readonly BezierSpan? _span;
    private readonly PowerBasis? _powers;
    private readonly double[] _lengths = [];

    private ChainPiece(in Segment segment, double start)
    {
        (_segment, Start) = (segment, start);
        if (segment.IsFreeCurve)
        {
            _span = segment.Curve.Spans[0];
            _powers = new PowerBasis(_span);
            _lengths = new double[TableSteps + 1];
            for (var i = 0; i < TableSteps; i++) _lengths[i + 1] = _lengths[i] + ArcLength.Measure(_powers.Speed, (double)i / TableSteps, (i + 1.0) / TableSteps);
            Length = _lengths[^1];
        }
        else
        {
            Length = segment.Length;
        }
    }

    /// <summary>Length of the chain before this piece, millimetres.</summary>
    public double Start { get; }

    public double Length { get; }

    public double End => Start + Length;

    public bool IsFree => _span is not null;

    public bool IsLine => _segment.Kind == SegmentKind.Line;

    /// <summary>The line or arc itself, or the part of the curve.</summary>
    public Segment Segment => _segment;

    public Point2D StartPoint => _segment.Start;

    public Point2D EndPoint => _segment.End;

    /// <summary>The pieces of a segment, which together are exactly the segment.</summary>
    public static IEnumerable<ChainPiece> Of(Segment segment, double start)
    {
        IEnumerable<Segment> parts = segment.IsFreeCurve ? segment.Curve.Pieces().Select(piece => IsStraight(piece.Spans[0]) ? Segment.FromLine(piece.Start, piece.End) : Segment.FromCurve(piece)) : [segment];
        foreach (var part in parts)
        {
            var piece = new ChainPiece(part, start);
            if (!(piece.Length > 0.0)) continue;
            start = piece.End;
            yield return piece;
        }
    }

    public ChainPoint At(double fraction)
    {
        if (_span is null)
        {
            if (IsLine) return new ChainPoint(_segment.PointAt(fraction), _segment.StartTangent, 0.0);
            return new ChainPoint(_segment.Arc.PointAt(fraction), _segment.Arc.TangentAt(fraction), Math.Sign(_segment.Arc.Sweep.Degrees) / _segment.Arc.Radius);
        }

        return new ChainPoint(_span.PointAt(fraction), _span.TangentAt(fraction), Curvature(fraction));
    }

    /// <summary>Point and direction of travel by a fast method: for measurements at samples, which are not part of a proof.</summary>
    public (Point2D Point, Vector2D Tangent) Near(double fraction)
    {
        if (_powers is null) return At(fraction) is var place ? (place.Point, place.Tangent) : default;
        var point = _powers.Evaluate(fraction, out var slope);
        var speed = slope.Length;
        return (point, speed > 0.0 ? slope * (1.0 / speed) : _span!.TangentAt(fraction));
    }

    /// <summary>The fraction at a length from the start of the chain.</summary>
    public double FractionAt(double length)
    {
        var along = length - Start;
        if (_span is null) return Math.Clamp(along / Length, 0.0, 1.0);
        if (along <= 0.0) return 0.0;
        if (along >= Length) return 1.0;
        var cell = Array.BinarySearch(_lengths, along);
        if (cell < 0) cell = ~cell - 1;
        cell = Math.Clamp(cell, 0, TableSteps - 1);
        var share = (along - _lengths[cell]) / Math.Max(_lengths[cell + 1] - _lengths[cell], double.Epsilon);
        return (cell + Math.Clamp(share, 0.0, 1.0)) / TableSteps;
    }

    /// <summary>The length from the start of the chain at a fraction. The inverse of <see cref="FractionAt"/>; for a free piece it is linear between the
    /// entries of its table, which only moves points along the curve.</summary>
    public double LengthAt(double fraction)
    {
        if (_span is null) return Start + (fraction * Length);
        var place = Math.Clamp(fraction, 0.0, 1.0) * TableSteps;
        var cell = Math.Min((int)place, TableSteps - 1);
        return Start + _lengths[cell] + ((place - cell) * (_lengths[cell + 1] - _lengths[cell]));
    }

    /// <summary>The length of the chain up to a fraction, by quadrature: for times, for which <see cref="LengthAt"/> is too coarse where the curve's speed
    /// changes much within a step of its table, for example after a double control point.</summary>
    public double ArcLengthAt(double fraction)
    {
        if (_span is null) return LengthAt(fraction);
        fraction = Math.Clamp(fraction, 0.0, 1.0);
        return Start + FreeLength(Math.Min((int)(fraction * TableSteps), TableSteps - 1), fraction);
    }

    /// <summary>The inverse of <see cref="ArcLengthAt"/>.</summary>
    public double FractionAtArcLength(double length)
    {
        if (_span is null || length <= Start || length >= End) return FractionAt(length);
        var cell = Array.BinarySearch(_lengths, length - Start);
        return InCell(Math.Clamp(cell < 0 ? ~cell - 1 : cell, 0, TableSteps - 1), length - Start, FractionAt(length));
    }

    /// <summary>The fraction whose normal passes through a place, with a search from an initial guess; below 0 or above 1 when it is beyond an end.</summary>
    public double Foot(Point2D place, double guess, double near = 1e-6)
    {
        if (_span is not null) return FreeFoot(place, guess, near);
        if (IsLine) return (place - _segment.Start).Dot(_segment.StartTangent) / Length;
        var arc = _segment.Arc;
        var ahead = arc.TangentAt(guess).Dot(place - arc.Centre);
        var outwards = Vector2D.FromPolar(1.0, arc.Start + (arc.Sweep * guess)).Dot(place - arc.Centre);
        return guess + (Math.Atan2(ahead, outwards) / Math.Abs(arc.Sweep.Radians));
    }

    /// <summary>The part between two fractions as a Bezier span, exact within rounding; for an arc at most a third of a turn.</summary>
    /// <returns>Null for an arc that is too long.</returns>
    public BezierSpan? Part(double from, double to)
    {
        if (_span is not null) return _span.Part(from, to);
        var (start, end) = (from <= 0.0 ? _segment.Start : _segment.PointAt(from), to >= 1.0 ? _segment.End : _segment.PointAt(to));
        if (IsLine) return new BezierSpan([start.X, start.Y, 0.0, 1.0, end.X, end.Y, 0.0, 1.0]);
        var arc = _segment.Arc;
        var half = Math.Abs(arc.Sweep.Radians) * (to - from) / 2.0;
        if (half > Math.PI / 3.0) return null;
        var weight = Math.Cos(half);
        var shoulder = arc.Centre + Vector2D.FromPolar(arc.Radius / weight, arc.Start + (arc.Sweep * ((from + to) / 2.0)));
        return new BezierSpan([start.X, start.Y, 0.0, 1.0, shoulder.X * weight, shoulder.Y * weight, 0.0, weight, end.X, end.Y, 0.0, 1.0]);
    }

    /// <summary>Length of a free piece from its start to a fraction within a step of the table.</summary>
    private double FreeLength(int cell, double fraction) => _lengths[cell] + ArcLength.Measure(_powers!.Speed, (double)cell / TableSteps, fraction);

    /// <summary>Newton's steps on the length; where the curve's speed is nearly 0, bisection of the remaining interval.</summary>
    /// <param name="along">Length from the start of the piece: added to the length of a long chain, its last digits would be lost by rounding.</param>
    private double InCell(int cell, double along, double fraction)
    {
        var (low, high) = ((double)cell / TableSteps, (cell + 1.0) / TableSteps);
        for (var step = 0; step < MaxLengthSteps; step++)
        {
            var off = FreeLength(cell, fraction) - along;
            if (Math.Abs(off) <= LengthShare * Length) return fraction;
            (low, high) = off > 0.0 ? (low, fraction) : (fraction, high);
            var next = fraction - (off / _powers!.Speed(fraction));
            fraction = next > low && next < high ? next : (low + high) / 2.0;
        }

        return fraction;
    }

    private double FreeFoot(Point2D place, double guess, double near)
    {
        var fraction = Math.Clamp(guess, 0.0, 1.0);
        for (var step = 0; step < MaxNewtonSteps; step++)
        {
            var on = _powers!.Evaluate(fraction, out var slope);
            var squared = slope.LengthSquared;
            if (!(squared > 0.0)) return fraction;
            var by = (place - on).Dot(slope) / squared;
            var next = fraction + by;
            if (next < 0.0 && fraction <= 0.0) return next;
            if (next > 1.0 && fraction >= 1.0) return next;
            next = Math.Clamp(next, 0.0, 1.0);
            if (Math.Abs(next - fraction) < near) return next;
            fraction = next;
        }

        return fraction;
    }

    /// <summary>Signed curvature by differences of the tangent; it only controls the density of points and is not part of a proof.</summary>
    private double Curvature(double fraction)
    {
        const double Step = 1e-4;
        var (from, to) = (Math.Max(0.0, fraction - Step), Math.Min(1.0, fraction + Step));
        var before = _powers!.Evaluate(from, out var first);
        var after = _powers.Evaluate(to, out var second);
        var chord = before.DistanceTo(after);
        return chord > 0.0 ? Math.Atan2(first.Cross(second), first.Dot(second)) / chord : 0.0;
    }

    /// <summary>True when the control points are on a straight line from end to end, as between the triple points with which some programs write the corners of
    /// a polygon: the curve's speed can be 0 there, where its curvature is only due to rounding, but it is a line.</summary>
    private static bool IsStraight(BezierSpan span)
    {
        var chord = span.End - span.Start;
        if (!(chord.Length > 0.0)) return false;
        var (along, before) = (chord * (1.0 / chord.Length), 0.0);
        for (var i = 1; i <= span.Degree; i++)
        {
            var from = span.Control(i) - span.Start;
            var ahead = from.Dot(along);
            if (Math.Abs(from.Cross(along)) > StraightWithin || ahead < before - StraightWithin || !(span.Weight(i) > 0.0)) return false;
            before = ahead;
        }

        return true;
    }
}
