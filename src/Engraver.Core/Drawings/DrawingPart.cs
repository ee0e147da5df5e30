using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>One line, arc, circle, ellipse or spline of a drawing, in drawing units and world coordinates (OCS applied).</summary>
/// <remarks>Line: A,B,C = start x,y,z; D,E,F = end x,y,z. Arc and circle: A,B,C = centre x,y,z; D = radius; E = start angle and F = signed sweep, degrees, as
/// seen from +z. Ellipse and spline: A = index into <see cref="Drawing.Curves"/>, the rest 0.</remarks>
public struct DrawingPart
{
    public double A;
    public double B;
    public double C;
    public double D;
    public double E;
    public double F;

    /// <summary>The curve this part belongs to: index into <see cref="Drawing.Entities"/>.</summary>
    public int Entity;

    public SegmentKind Kind;

    /// <summary>True for an ellipse or spline, whose geometry is in <see cref="Drawing.Curves"/>.</summary>
    public readonly bool IsFreeCurve => Kind is SegmentKind.Ellipse or SegmentKind.Spline;

    /// <summary>Index of an ellipse or spline in <see cref="Drawing.Curves"/>.</summary>
    public readonly int CurveIndex => (int)A;

    /// <summary>Length along a line, arc or circle in space, drawing units (for every part: <see cref="Drawing.SpaceLengthOf"/>).</summary>
    public readonly double SpaceLength => Kind == SegmentKind.Line
        ? Math.Sqrt(((D - A) * (D - A)) + ((E - B) * (E - B)) + ((F - C) * (F - C)))
        : D * Math.Abs(Angle.FromDegrees(F).Radians);

    public static DrawingPart Line(int entity, double x1, double y1, double z1, double x2, double y2, double z2) =>
        new() { Kind = SegmentKind.Line, Entity = entity, A = x1, B = y1, C = z1, D = x2, E = y2, F = z2 };

    /// <summary>An arc, or a circle when the sweep is exactly +-360 degrees.</summary>
    public static DrawingPart Arc(int entity, ArcSegment arc, double z) => new()
    {
        Kind = arc.IsFullTurn ? SegmentKind.Circle : SegmentKind.Arc,
        Entity = entity,
        A = arc.Centre.X,
        B = arc.Centre.Y,
        C = z,
        D = arc.Radius,
        E = arc.Start.Degrees,
        F = arc.Sweep.Degrees,
    };

    /// <summary>An ellipse or spline in the column of curves.</summary>
    public static DrawingPart FreeCurve(int entity, SegmentKind kind, int curveIndex) => new() { Kind = kind, Entity = entity, A = curveIndex };

    /// <summary>A line, arc or circle in plan (z dropped), drawing units (for every part: <see cref="Drawing.SegmentOf"/>).</summary>
    public readonly Segment InPlan() => Kind == SegmentKind.Line
        ? Segment.FromLine(new Point2D(A, B), new Point2D(D, E))
        : Segment.FromArc(new ArcSegment(new Point2D(A, B), D, Angle.FromDegrees(E), Angle.FromDegrees(F)));

    /// <summary>A line, arc or circle under a similarity of the plane; heights are scaled with it, so it keeps its slope. (Ellipses and splines are in their
    /// own column.)</summary>
    public readonly DrawingPart Transformed(Transform2D map)
    {
        if (Kind != SegmentKind.Line) return Arc(Entity, map.Apply(InPlan().Arc), C * map.Scale);
        var start = map.Apply(new Point2D(A, B));
        var end = map.Apply(new Point2D(D, E));
        return Line(Entity, start.X, start.Y, C * map.Scale, end.X, end.Y, F * map.Scale);
    }

    /// <summary>False when a coordinate of a line, arc or circle is above the largest, or its radius is 0. True for an ellipse or spline, whose numbers are
    /// in their own column.</summary>
    internal readonly bool InRange =>
        IsFreeCurve || (Drawing.Holds(A) && Drawing.Holds(B) && Drawing.Holds(C) && Drawing.Holds(D) && Drawing.Holds(E) && Drawing.Holds(F) && (Kind == SegmentKind.Line || D > 0.0));

    /// <summary>True when both are equal in every number.</summary>
    public static bool AreSame(in DrawingPart one, in DrawingPart other) =>
        one.Entity == other.Entity && one.Kind == other.Kind && IsSame(one.A, other.A) && IsSame(one.B, other.B) && IsSame(one.C, other.C) && IsSame(one.D, other.D) && IsSame(one.E, other.E) && IsSame(one.F, other.F);

    /// <summary>The points of a line, arc or circle in the opposite direction.</summary>
    public readonly DrawingPart Reversed() => Kind == SegmentKind.Line ? Line(Entity, D, E, F, A, B, C)
        : Arc(Entity, InPlan().Arc.Reversed(), C);

    /// <summary>Compares to the last bit: 0 and -0 are different numbers.</summary>
    private static bool IsSame(double one, double other) => BitConverter.DoubleToInt64Bits(one) == BitConverter.DoubleToInt64Bits(other);
}
