using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>One edge of a hatch boundary: the pairs from its group 72 to the next.</summary>
internal static class HatchEdge
{
    public static double Value(ReadOnlySpan<CodedNumber> edge, int code, double otherwise)
    {
        foreach (var pair in edge)
        {
            if (pair.Code == code) return pair.Value;
        }

        return otherwise;
    }

    /// <summary>The 2D vector of a code and code + 10; null when it is missing or has no length.</summary>
    public static Vector3D? Vector(ReadOnlySpan<CodedNumber> edge, int code)
    {
        var vector = new Vector3D(Value(edge, code, 0.0), Value(edge, code + 10, 0.0), 0.0);
        return vector == default ? null : vector;
    }

    /// <summary>Adds a straight edge.</summary>
    public static void AddLine(ReadOnlySpan<CodedNumber> edge, double elevation, CurveShape shape)
    {
        var (start, end) = (Point(edge, 10), Point(edge, 11));
        if (start != end) shape.Add(DrawingPartOf(start, end, elevation));
    }

    /// <summary>Adds a circular edge. A clockwise one (73 = 0) has its angles measured clockwise too: it runs from -start to -end.</summary>
    public static void AddArc(EntityRecord record, ReadOnlySpan<CodedNumber> edge, double elevation, CurveShape shape)
    {
        var radius = Math.Abs(Value(edge, 40, 0.0));
        var (start, sweep) = SpanOf(record, edge, shape, angle => angle);
        if (radius > 0.0 && sweep != 0.0) shape.Add(Drawings.DrawingPart.Arc(0, new ArcSegment(Point(edge, 10), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep)), elevation));
    }

    /// <summary>Adds an elliptical edge. Its angles are true angles from the major axis, unlike the parameters of an ELLIPSE: only with this interpretation do
    /// the edges of real boundaries meet.</summary>
    public static void AddEllipse(EntityRecord record, ReadOnlySpan<CodedNumber> edge, double elevation, CurveShape shape)
    {
        var (centre, major, ratio) = (Point(edge, 10), Point(edge, 11), Value(edge, 40, 1.0));
        if (ratio == 0.0 || major == default) return;
        var (start, sweep) = SpanOf(record, edge, shape, angle => ToParameter(angle, Math.Abs(ratio)));
        if (sweep == 0.0) return;
        shape.Add(new EllipseArc(
            new Vector3D(centre.X, centre.Y, elevation), new Vector3D(major.X, major.Y, 0.0), new Vector3D(-major.Y * ratio, major.X * ratio, 0.0), Angle.FromDegrees(start), Angle.FromDegrees(sweep)));
    }

    public static Drawings.DrawingPart DrawingPartOf(Point2D start, Point2D end, double elevation) =>
        Drawings.DrawingPart.Line(0, start.X, start.Y, elevation, end.X, end.Y, elevation);

    private static Point2D Point(ReadOnlySpan<CodedNumber> edge, int code) => new(Value(edge, code, 0.0), Value(edge, code + 10, 0.0));

    /// <summary>The turn is that of the written angles: in a flat ellipse one degree beyond a whole turn becomes a large change of the parameter.</summary>
    private static (double Start, double Sweep) SpanOf(EntityRecord record, ReadOnlySpan<CodedNumber> edge, CurveShape shape, Func<double, double> parameter)
    {
        var (first, last) = (Value(edge, 50, 0.0), Value(edge, 51, 360.0));
        var span = TurnSpan.Between(first, last, 360.0);
        if (span.IsWrapped) shape.Warnings.Add(record.Finding(DxfRules.MoreThanOneTurn, (last - first).ToString(CultureInfo.InvariantCulture), refused: false));
        var start = parameter(first);
        var sweep = span.Sweep == 360.0 ? 360.0 : parameter(first + span.Sweep) - start;
        return Value(edge, 73, 1.0) == 0.0 ? (-start, -sweep) : (start, sweep);
    }

    /// <summary>The ellipse parameter of the point at this true angle, in the same quarter turn.</summary>
    private static double ToParameter(double degrees, double ratio)
    {
        var angle = Angle.FromDegrees(degrees);
        var (cos, sin) = (angle.Cos(), angle.Sin());
        var correction = (Math.Atan2(sin / ratio, cos) - Math.Atan2(sin, cos)) * (180.0 / Math.PI);
        return degrees + correction;
    }
}
