using System.Runtime.InteropServices;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>Converts construction that the operator has chosen to cut into curves: one for each loop of a HATCH, each element of an MLINE, each run of visible
/// edges.</summary>
internal sealed class OutlineMapper(MultiLineStyles styles)
{
    private const int AllEdges = 4;
    private readonly HatchMapper _hatches = new();
    private readonly SplineMapper _splines = new();

    /// <summary>The curves of the record that was mapped last; until <see cref="Finish"/> including those without length.</summary>
    public List<CurveShape> Shapes { get; } = [];

    public void Map(EntityRecord record)
    {
        Shapes.Clear();
        switch (record.Kind)
        {
            case RecordKind.Hatch:
                _hatches.Map(record, Shapes);
                break;
            case RecordKind.MultiLine:
                MultiLineMapper.Map(record, styles, Shapes);
                break;
            case RecordKind.Leader:
                Leader(record);
                break;
            case RecordKind.Helix:
                Helix(record);
                break;
            default:
                Face(record);
                break;
        }

        if (Shapes.Exists(shape => !shape.IsInRange)) record.Refuse(DxfRules.OutOfRange, record.Line, "");
    }

    /// <summary>Leaves out curves without length, and refuses the record when none is left.</summary>
    public void Finish(EntityRecord record)
    {
        Shapes.RemoveAll(shape => shape.Parts.IsEmpty);
        if (Shapes.Count == 0) record.Refuse(DxfRules.OutlineUnusable, record.Line, Wording.Get("OutlineMapper.NoEdgeWithLength"));
    }

    /// <summary>A leader's vertices are in world coordinates; 72 = 1 draws a spline through them.</summary>
    private void Leader(EntityRecord record)
    {
        var points = new List<Vector3D>();
        foreach (var point in VertexRun.Read(CollectionsMarshal.AsSpan(record.Sequence), 10))
        {
            if (points.Count == 0 || VertexRun.AreApart(points[^1], point)) points.Add(point);
        }

        if (points.Count < 2) return;
        var shape = Begin(CurveType.Leader);
        if (record.First(72, 0.0) == 1.0 && points.Count > 2) shape.Add(FitPointSpline.Through(points, null, null, closed: false));
        else VertexRun.Connect(points, closed: false, shape);
        Shapes.Add(shape);
    }

    /// <summary>A helix stores its exact spline before its own values.</summary>
    private void Helix(EntityRecord record)
    {
        var own = record.Sequence.FindIndex(pair => pair.Code == 100 && record.Texts[(int)pair.Value].Value == "AcDbHelix");
        if (own >= 0) record.Sequence.RemoveRange(own, record.Sequence.Count - own);
        var shape = Begin(CurveType.Helix);
        _splines.Map(record, shape);
        Shapes.Add(shape);
    }

    private void Face(EntityRecord record)
    {
        var flat = record.Type != "3DFACE";
        var corners = new List<Vector3D>();
        foreach (var code in (ReadOnlySpan<int>)(flat ? [10, 11, 13, 12] : [10, 11, 12, 13]))
        {
            // Without a fourth corner it is a triangle; SOLID and TRACE run 1-2-4-3.
            if (record.Has(code)) corners.Add(new Vector3D(record.Number(code, 0.0), record.Number(code + 10, 0.0), record.Number(code + 20, 0.0)));
        }

        var hidden = flat ? 0 : record.Flags(70);
        for (var edge = 0; edge < corners.Count && corners.Count > 2; edge++)
        {
            var shape = Begin(record.Type switch { "SOLID" => CurveType.Solid, "TRACE" => CurveType.Trace, _ => CurveType.Face3D });
            for (; edge < corners.Count && (hidden & (1 << Math.Min(edge, AllEdges - 1))) == 0; edge++) VertexRun.AddLine(corners[edge], corners[(edge + 1) % corners.Count], shape);
            shape.Closed = hidden == 0;
            if (flat) ObjectCoordinateSystem.TransformToWorld(record, shape);
            if (!shape.Parts.IsEmpty) Shapes.Add(shape);
        }
    }

    private static CurveShape Begin(CurveType type)
    {
        var shape = new CurveShape();
        shape.Begin(type);
        return shape;
    }
}
