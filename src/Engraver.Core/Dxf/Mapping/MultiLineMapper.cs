using System.Runtime.InteropServices;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>The lines of an MLINE (DXF reference): element n passes through vertex + mitre direction times its first parameter at every vertex, which includes
/// scale, justification and mitres. Breaks are ignored.</summary>
internal static class MultiLineMapper
{
    private const int ClosedFlag = 2;
    private const int NoStartCap = 4;
    private const int NoEndCap = 8;

    public static void Map(EntityRecord record, MultiLineStyles styles, List<CurveShape> shapes)
    {
        var rows = Rows(CollectionsMarshal.AsSpan(record.Sequence));
        var elements = rows.Count == 0 ? 0 : rows.Min(row => row.Count);
        var flags = record.Flags(71);
        var closed = (flags & ClosedFlag) != 0;
        for (var element = 0; element < elements; element++) Add(shapes, shape => VertexRun.Connect([.. rows.Select(row => row[element])], closed, shape));
        if (elements < 2 || rows.Count < 2) return;
        foreach (var row in rows) row.RemoveRange(elements, row.Count - elements); // a damaged vertex may have more elements than another
        var style = styles[record.TextOf(2)];
        if (style.HasFlag(MultiLineStyleFlags.Joints))
        {
            foreach (var row in closed ? rows : rows[1..^1]) Add(shapes, shape => VertexRun.AddLine(row[0], row[elements - 1], shape));
        }

        if (closed) return;
        if ((flags & NoStartCap) == 0) Cap(shapes, rows[0], rows[1], (int)style / (int)MultiLineStyleFlags.StartLine);
        if ((flags & NoEndCap) == 0) Cap(shapes, rows[^1], rows[^2], (int)style / (int)MultiLineStyleFlags.EndLine);
    }

    /// <summary>For each vertex the points at which its elements cross the mitre.</summary>
    private static List<List<Vector3D>> Rows(ReadOnlySpan<CodedNumber> pairs)
    {
        var rows = new List<List<Vector3D>>();
        for (var at = 0; at < pairs.Length; at++)
        {
            if (pairs[at].Code != 11) continue;
            var next = at + 1;
            while (next < pairs.Length && pairs[next].Code != 11) next++;
            rows.Add(Crossings(pairs[at..next]));
            at = next - 1;
        }

        return rows;
    }

    /// <summary>Group 74 announces the parameters of the next element; the first 41 after it is the distance along the mitre.</summary>
    private static List<Vector3D> Crossings(ReadOnlySpan<CodedNumber> vertex)
    {
        var points = new List<Vector3D>();
        var (place, mitre) = (VertexRun.Read(vertex, 11), VertexRun.Read(vertex, 13));
        if (place.Count == 0 || mitre.Count == 0) return points;
        var waits = false;
        foreach (var (code, value) in vertex)
        {
            if (code == 74) waits = true;
            else if (code == 41 && waits)
            {
                points.Add(place[0] + (mitre[0] * value));
                waits = false;
            }
        }

        return points;
    }

    /// <param name="bits">1 a line, 2 arcs between inner pairs, 4 a half circle around all.</param>
    private static void Cap(List<CurveShape> shapes, List<Vector3D> row, List<Vector3D> neighbour, int bits)
    {
        if ((bits & 1) != 0) Add(shapes, shape => VertexRun.AddLine(row[0], row[^1], shape));
        if ((bits & 4) != 0) Add(shapes, shape => HalfCircle(row[0], row[^1], neighbour[0], shape));
        for (var pair = 1; (bits & 2) != 0 && pair < row.Count - 1 - pair; pair++)
        {
            var (first, last) = (row[pair], row[row.Count - 1 - pair]);
            Add(shapes, shape => HalfCircle(first, last, neighbour[pair], shape));
        }
    }

    /// <summary>The half circle over two ends, on the side away from the multiline.</summary>
    private static void HalfCircle(Vector3D from, Vector3D to, Vector3D inside, CurveShape shape)
    {
        var (start, end) = (new Point2D(from.X, from.Y), new Point2D(to.X, to.Y));
        if (start == end) return;
        var side = (end - start).Cross(new Point2D(inside.X, inside.Y) - start);
        shape.Add(DrawingPart.Arc(0, ArcSegment.FromBulge(start, end, side > 0.0 ? 1.0 : -1.0), from.Z)); // a positive bulge is to the right of its chord
    }

    private static void Add(List<CurveShape> shapes, Action<CurveShape> draw)
    {
        var shape = new CurveShape();
        shape.Begin(CurveType.MLine);
        draw(shape);
        if (!shape.Parts.IsEmpty) shapes.Add(shape);
    }
}
