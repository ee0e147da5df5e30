using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>The lines and arcs between the vertices of a polyline.</summary>
internal static class PolylineParts
{
    /// <summary>
    /// Below this bulge a straight part is more exact: its distance from the arc is bulge/2 of the chord, while the arc's centre is 1/(4 bulge) chords away and
    /// rounded to 1e-16 of that. The two errors are equal near 1e-8.
    /// </summary>
    private const double StraightBulge = 1e-8;

    /// <summary>Adds the parts to the shape; two vertices at one point have no part between them. The last bulge counts only when the polyline is
    /// closed.</summary>
    public static void Connect(ReadOnlySpan<PolylineVertex> vertices, bool closed, CurveShape shape)
    {
        for (var i = 1; i < vertices.Length; i++) Connect(vertices[i - 1], vertices[i], shape);
        if (closed && vertices.Length > 1) Connect(vertices[^1], vertices[0], shape);
        shape.Closed = closed && shape.Parts.Length > 0;
    }

    private static void Connect(PolylineVertex from, PolylineVertex to, CurveShape shape)
    {
        if (from.X == to.X && from.Y == to.Y && from.Z == to.Z) return;
        var straight = Math.Abs(from.Bulge) < StraightBulge || (from.X == to.X && from.Y == to.Y);
        shape.Add(straight
            ? DrawingPart.Line(0, from.X, from.Y, from.Z, to.X, to.Y, to.Z)
            : DrawingPart.Arc(0, ArcSegment.FromBulge(new Point2D(from.X, from.Y), new Point2D(to.X, to.Y), from.Bulge), from.Z));
    }
}

/// <summary>A vertex of a polyline in the polyline's own system; the bulge belongs to the part that starts here.</summary>
internal record struct PolylineVertex(double X, double Y, double Z, double Bulge);
