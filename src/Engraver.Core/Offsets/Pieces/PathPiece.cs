using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets.Pieces;

/// <summary>A line or an arc with a direction, stored so that distances and crossings need no angles: an offset uses hundreds of thousands of them.</summary>
/// <remarks>Start and end are stored: neighbours share them exactly. An arc of a full turn ends at its start.</remarks>
internal readonly struct PathPiece
{
    private const double WholeTurn = 2.0 * Math.PI;

    /// <summary>Radians by which a sweep may differ from a full turn and still count as one.</summary>
    private const double TurnRounding = 1e-12;

    /// <summary>Rounding of a distance from the centre of an arc, in radii.</summary>
    private const double RadiusRounding = 1e-15;

    /// <summary>Radius from which an arc must have a minimum height, millimetres.</summary>
    private const double LargestRadius = 1e9;

    /// <summary>Minimum height of such an arc, millimetres.</summary>
    private const double LowestArc = 1e-4;

    private PathPiece(Point2D start, Point2D end, Point2D centre, double radius, double from, double sweep, double length) =>
        (Start, End, Centre, Radius, From, Sweep, Length) = (start, end, centre, radius, from, sweep, length);

    public Point2D Start { get; }

    public Point2D End { get; }

    /// <summary>Centre of an arc.</summary>
    public Point2D Centre { get; }

    /// <summary>0 for a line.</summary>
    public double Radius { get; }

    /// <summary>Direction of an arc's start from its centre, radians.</summary>
    public double From { get; }

    /// <summary>Sweep in radians, counter-clockwise positive; 0 for a line.</summary>
    public double Sweep { get; }

    public double Length { get; }

    public bool IsArc => Radius > 0.0;

    public bool IsWholeTurn => IsArc && Math.Abs(Sweep) >= WholeTurn - TurnRounding;

    public Vector2D StartTangent => IsArc ? Along(Start - Centre) : (End - Start) * (1.0 / Length);

    public Vector2D EndTangent => IsArc ? Along(End - Centre) : (End - Start) * (1.0 / Length);

    public static PathPiece Line(Point2D start, Point2D end) => new(start, end, default, 0.0, 0.0, 0.0, start.DistanceTo(end));

    /// <param name="centre">Centre of the circle.</param>
    /// <param name="radius">Above 0.</param>
    /// <param name="from">Direction of the start, radians.</param>
    /// <param name="sweep">Sweep in radians, counter-clockwise positive, not 0.</param>
    /// <param name="start">On the circle, to rounding.</param>
    /// <param name="end">On the circle, to rounding.</param>
    public static PathPiece Arc(Point2D centre, double radius, double from, double sweep, Point2D start, Point2D end) =>
        new(start, end, centre, radius, from, sweep, radius * Math.Abs(sweep));

    /// <summary>A line or an arc; an arc is replaced by its chord when rounding of its radius moves it farther than the chord would, or when it is very flat
    /// with a radius of more than a thousand kilometres.</summary>
    public static PathPiece FromSegment(in Segment segment)
    {
        if (segment.Kind == SegmentKind.Line) return Line(segment.Start, segment.End);
        var arc = segment.Arc;
        var height = arc.Radius * arc.Sweep.Radians * arc.Sweep.Radians / 8.0;
        if (height < RadiusRounding * arc.Radius || (arc.Radius > LargestRadius && height < LowestArc)) return Line(segment.Start, segment.End);
        return Arc(arc.Centre, arc.Radius, arc.Start.Radians, arc.Sweep.Radians, segment.Start, segment.End);
    }

    public Segment ToSegment()
    {
        if (!IsArc) return Segment.FromLine(Start, End);
        var sweep = IsWholeTurn ? Angle.FullTurn * Math.Sign(Sweep) : Angle.FromRadians(Sweep);
        return Segment.FromArc(new ArcSegment(Centre, Radius, Angle.FromRadians(From), sweep), Start, End);
    }

    public PathPiece Reversed() => new(End, Start, Centre, Radius, From + Sweep, -Sweep, Length);

    public PathPiece Moved(Vector2D by) => new(Start + by, End + by, Centre + by, Radius, From, Sweep, Length);

    /// <summary>The point at a fraction of the length.</summary>
    public Point2D At(double fraction)
    {
        if (!IsArc) return Start + ((End - Start) * fraction);
        var (sin, cos) = Math.SinCos(From + (Sweep * fraction));
        return Centre + new Vector2D(Radius * cos, Radius * sin);
    }

    /// <summary>Between two fractions, with ends that are given more exactly.</summary>
    public PathPiece Part(double from, Point2D start, double to, Point2D end)
    {
        if (!IsArc) return Line(start, end);
        return from == 0.0 && to == 1.0 ? Arc(Centre, Radius, From, Sweep, start, end) : Arc(Centre, Radius, From + (Sweep * from), Sweep * (to - from), start, end);
    }

    public Bounds2D Box()
    {
        var box = Bounds2D.FromCorners(Start, End);
        if (!IsArc) return box;
        if (Covers(new Vector2D(1.0, 0.0))) box = box.Including(Centre + new Vector2D(Radius, 0.0));
        if (Covers(new Vector2D(0.0, 1.0))) box = box.Including(Centre + new Vector2D(0.0, Radius));
        if (Covers(new Vector2D(-1.0, 0.0))) box = box.Including(Centre - new Vector2D(Radius, 0.0));
        return Covers(new Vector2D(0.0, -1.0)) ? box.Including(Centre - new Vector2D(0.0, Radius)) : box;
    }

    public double DistanceTo(Point2D place)
    {
        if (!IsArc)
        {
            var along = End - Start;
            var fraction = Math.Clamp((place - Start).Dot(along) / (Length * Length), 0.0, 1.0);
            return Norm(place - (Start + (along * fraction)));
        }

        var spoke = place - Centre;
        return Covers(spoke) ? Math.Abs(Norm(spoke) - Radius) : Math.Min(Norm(place - Start), Norm(place - End));
    }

    /// <summary>True when an arc passes through this direction from its centre (ends included).</summary>
    public bool Covers(Vector2D spoke)
    {
        if (IsWholeTurn) return true;
        var (first, last) = Sweep > 0.0 ? (Start - Centre, End - Centre) : (End - Centre, Start - Centre);
        var (afterFirst, beforeLast) = (first.Cross(spoke), spoke.Cross(last));
        return Math.Abs(Sweep) <= Math.PI ? afterFirst >= 0.0 && beforeLast >= 0.0 : afterFirst >= 0.0 || beforeLast >= 0.0;
    }

    /// <summary>The fraction of the length of a point on the line or circle; outside 0 to 1 when the point is beyond an end (of an arc: the nearer
    /// end).</summary>
    public double FractionOf(Point2D place)
    {
        if (!IsArc) return (place - Start).Dot(End - Start) / (Length * Length);
        var sweep = Math.Abs(Sweep);
        var ahead = AngleAhead(place - Centre);
        if (ahead > sweep && ahead - sweep > WholeTurn - ahead) ahead -= WholeTurn;
        return ahead / sweep;
    }

    /// <summary>Angle from the start of an arc to a direction, in the arc's direction of travel, radians in [0, 2 pi).</summary>
    public double AngleAhead(Vector2D spoke)
    {
        var start = Start - Centre;
        var angle = Math.Atan2(Math.Sign(Sweep) * start.Cross(spoke), start.Dot(spoke));
        return angle < 0.0 ? angle + WholeTurn : angle;
    }

    public static double Norm(Vector2D vector) => Math.Sqrt(vector.LengthSquared);

    private Vector2D Along(Vector2D spoke)
    {
        var scale = Math.Sign(Sweep) / Norm(spoke);
        return new Vector2D(-spoke.Y * scale, spoke.X * scale);
    }
}
