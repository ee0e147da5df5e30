using System.Runtime.InteropServices;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>The boundaries of a HATCH (DXF reference, "Boundary Path Data"): each loop a curve, empty where it has no length. Announced numbers (91, 93) are
/// not relied on.</summary>
internal sealed class HatchMapper
{
    private const int LoopStart = 92;
    private const int EdgeStart = 72;
    private const int AfterLoops = 75;
    private const int PolylineFlag = 2;
    private readonly SplineMapper _splines = new();
    private readonly List<PolylineVertex> _vertices = [];

    public void Map(EntityRecord record, List<CurveShape> loops)
    {
        var pairs = CollectionsMarshal.AsSpan(record.Sequence);
        var elevation = record.Number(30, 0.0);
        var first = IndexOf(pairs, 0, LoopStart);
        var end = IndexOf(pairs, first, AfterLoops);
        for (var at = first; at < end;)
        {
            var next = Math.Min(IndexOf(pairs, at + 1, LoopStart), end);
            var loop = pairs[(at + 1)..next];
            var shape = new CurveShape();
            shape.Begin(CurveType.Hatch);
            if (((int)pairs[at].Value & PolylineFlag) != 0) AddPolyline(loop, elevation, shape);
            else AddEdges(record, loop, elevation, shape);
            ObjectCoordinateSystem.TransformToWorld(record, shape);
            loops.Add(shape);
            at = next;
        }
    }

    private static int IndexOf(ReadOnlySpan<CodedNumber> pairs, int from, int code)
    {
        for (var i = from; i < pairs.Length; i++)
        {
            if (pairs[i].Code == code) return i;
        }

        return pairs.Length;
    }

    private void AddPolyline(ReadOnlySpan<CodedNumber> loop, double elevation, CurveShape shape)
    {
        _vertices.Clear();
        foreach (var (code, value) in loop)
        {
            if (code == 10) _vertices.Add(new PolylineVertex(value, 0.0, elevation, 0.0));
            if (_vertices.Count == 0) continue;
            ref var vertex = ref CollectionsMarshal.AsSpan(_vertices)[^1];
            if (code == 20) vertex.Y = value;
            else if (code == 42) vertex.Bulge = value;
        }

        PolylineParts.Connect(CollectionsMarshal.AsSpan(_vertices), closed: HatchEdge.Value(loop, 73, 1.0) != 0.0, shape);
    }

    private void AddEdges(EntityRecord record, ReadOnlySpan<CodedNumber> loop, double elevation, CurveShape shape)
    {
        for (var at = IndexOf(loop, 0, EdgeStart); at < loop.Length;)
        {
            var next = IndexOf(loop, at + 1, EdgeStart);
            AddEdge(record, loop[at..next], elevation, shape);
            at = next;
        }

        shape.Closed = true;
    }

    private void AddEdge(EntityRecord record, ReadOnlySpan<CodedNumber> edge, double elevation, CurveShape shape)
    {
        switch ((int)edge[0].Value)
        {
            case 1:
                HatchEdge.AddLine(edge, elevation, shape);
                break;
            case 2:
                HatchEdge.AddArc(record, edge, elevation, shape);
                break;
            case 3:
                HatchEdge.AddEllipse(record, edge, elevation, shape);
                break;
            case 4:
                _splines.MapEdge(record, edge, shape);
                break;
            default:
                record.Refuse(Diagnostics.DxfRules.OutlineUnusable, record.Line, Wording.Get("HatchMapper.EdgeType", (int)edge[0].Value));
                break;
        }
    }
}
