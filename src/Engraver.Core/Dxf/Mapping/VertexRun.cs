using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>Points that follow each other in a record, and the straight lines between them.</summary>
internal static class VertexRun
{
    /// <summary>The points of a code that repeats (code, +10, +20); y and z may be missing.</summary>
    public static List<Vector3D> Read(ReadOnlySpan<CodedNumber> pairs, int code)
    {
        var points = new List<Vector3D>();
        foreach (var pair in pairs)
        {
            if (pair.Code == code) points.Add(new Vector3D(pair.Value, 0.0, 0.0));
            else if (points.Count > 0 && pair.Code == code + 10) points[^1] = points[^1] with { Y = pair.Value };
            else if (points.Count > 0 && pair.Code == code + 20) points[^1] = points[^1] with { Z = pair.Value };
        }

        return points;
    }

    /// <summary>False when the points coincide, or are so near that the square of their distance underflows.</summary>
    public static bool AreApart(Vector3D first, Vector3D second)
    {
        const double SmallestSquare = 1e-200;
        var step = second - first;
        return step.Dot(step) > SmallestSquare;
    }

    /// <summary>Joins neighbours by lines; two at one point have no line between them.</summary>
    public static void Connect(IReadOnlyList<Vector3D> points, bool closed, CurveShape shape)
    {
        for (var i = 1; i < points.Count; i++) AddLine(points[i - 1], points[i], shape);
        if (closed && points.Count > 2) AddLine(points[^1], points[0], shape);
        shape.Closed = closed;
    }

    public static void AddLine(Vector3D start, Vector3D end, CurveShape shape)
    {
        if (start != end) shape.Add(DrawingPart.Line(0, start.X, start.Y, start.Z, end.X, end.Y, end.Z));
    }
}
