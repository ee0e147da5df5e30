using System.Globalization;
using System.Runtime.InteropServices;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>Converts a record into the curve that it draws, in world coordinates (inside a block: the block's). A record that cannot be read gets a
/// fault.</summary>
internal sealed class CurveMapper
{
    /// <summary>Slope below which an ellipse counts as level.</summary>
    private const double LevelSlope = 1e-6;

    private readonly List<PolylineVertex> _vertices = [];

    /// <summary>Widths at the start and the end of the part after each vertex, drawing units.</summary>
    private readonly List<(double Start, double End)> _widths = [];
    private readonly SplineMapper _splines = new();

    public CurveShape Shape { get; } = new();

    public void Line(EntityRecord record)
    {
        Shape.Begin(CurveType.Line);
        var start = record.Point(10);
        var end = record.Point(11);
        // A line without length is also kept: the drawing's box includes its point, as in other DXF readers.
        Shape.Add(DrawingPart.Line(0, start.X, start.Y, start.Z, end.X, end.Y, end.Z));
        if (start.X == end.X && start.Y == end.Y) Note(record, DxfRules.NoLength, Wording.Get(start.Z == end.Z ? "CurveMapper.PointsCoincide" : "CurveMapper.VerticalLine"));
        Finish(record);
    }

    public void Circle(EntityRecord record)
    {
        Shape.Begin(CurveType.Circle);
        Shape.Closed = true;
        AddArc(record, 0.0, 360.0);
        ObjectCoordinateSystem.TransformToWorld(record, Shape);
        Finish(record);
    }

    public void Arc(EntityRecord record)
    {
        Shape.Begin(CurveType.Arc);
        var start = record.Required(50);
        var sweep = Sweep(record, start, record.Required(51), 360.0);
        Shape.Closed = sweep == 360.0;
        AddArc(record, start, sweep);
        ObjectCoordinateSystem.TransformToWorld(record, Shape);
        Finish(record);
    }

    public void Ellipse(EntityRecord record)
    {
        Shape.Begin(CurveType.Ellipse);
        var (centre, major, ratio) = (record.Point(10), record.Point(11), record.Required(40));
        var normal = record.Extrusion();
        if (normal == default) Note(record, DxfRules.NoExtrusion, "");
        var up = normal == default ? new Vector3D(0.0, 0.0, 1.0) : normal.Unit();
        var start = record.Number(41, 0.0);
        var sweep = Sweep(record, start, record.Number(42, Math.Tau), Math.Tau);
        var ellipse = new EllipseArc(centre, major, up.Cross(major) * ratio, Angle.FromRadians(start), sweep == Math.Tau ? Angle.FullTurn : Angle.FromRadians(sweep));
        Shape.Closed = ellipse.IsFullTurn;
        if (sweep != 0.0 && (major.X != 0.0 || major.Y != 0.0 || major.Z != 0.0)) Shape.Add(ellipse);
        if (IsTilted(up)) Note(record, DxfRules.TiltedCurve, "");
        Finish(record);
    }

    public void Spline(EntityRecord record)
    {
        Shape.Begin(CurveType.Spline);
        _splines.Map(record, Shape);
        Finish(record);
    }

    /// <param name="record">The polyline with its sequence of vertices.</param>
    /// <param name="atEndOfFile">True when the file stops after the record, so that vertices may be missing.</param>
    public void LwPolyline(EntityRecord record, bool atEndOfFile)
    {
        Shape.Begin(CurveType.LwPolyline);
        TakeVertices(record);
        record.Width = WidthOf((record.Flags(70) & 1) != 0, record.Number(43, 0.0));
        CheckCount(record, atEndOfFile);
        PolylineParts.Connect(CollectionsMarshal.AsSpan(_vertices), (record.Flags(70) & 1) != 0, Shape);
        ObjectCoordinateSystem.TransformToWorld(record, Shape);
        Finish(record);
    }

    /// <summary>Starts a POLYLINE; its vertices follow one by one, then <see cref="FinishPolyline"/>.</summary>
    public void BeginPolyline()
    {
        Shape.Begin(CurveType.Polyline);
        _vertices.Clear();
        _widths.Clear();
    }

    /// <summary>Records that the vertices ended without SEQEND although the file continues.</summary>
    public void NoteMissingEnd(EntityRecord record) => Note(record, DxfRules.PolylineWithoutEnd, "");

    /// <summary>Adds a VERTEX. Control points of a spline frame (flag 16) are not drawn.</summary>
    public void AddVertex(EntityRecord polyline, EntityRecord vertex)
    {
        var point = vertex.Point(10);
        var bulge = vertex.Number(42, 0.0);
        polyline.CopyFaultFrom(vertex);
        if ((vertex.Flags(70) & PolylineFlags.FrameVertex) != 0) return;
        _vertices.Add(new PolylineVertex(point.X, point.Y, point.Z, bulge));
        _widths.Add((vertex.Number(40, polyline.Number(40, 0.0)), vertex.Number(41, polyline.Number(41, 0.0))));
    }

    /// <summary>The curve of a POLYLINE whose vertices have been added. A 2D polyline is at its own elevation, a 3D one at the heights of its
    /// vertices.</summary>
    public void FinishPolyline(EntityRecord record)
    {
        var flags = record.Flags(70);
        if ((flags & PolylineFlags.Mesh) != 0) record.Refuse(DxfRules.MeshLeftOut, record.Line, "");
        var flat = (flags & PolylineFlags.InSpace) == 0;
        foreach (ref var vertex in CollectionsMarshal.AsSpan(_vertices)) vertex = flat ? vertex with { Z = record.Number(30, 0.0) } : vertex with { Bulge = 0.0 };
        PolylineParts.Connect(CollectionsMarshal.AsSpan(_vertices), (flags & PolylineFlags.Closed) != 0, Shape);
        record.Width = WidthOf((flags & PolylineFlags.Closed) != 0, 0.0);
        if (record.Number(40, 0.0) != 0.0 || record.Number(41, 0.0) != 0.0) Note(record, DxfRules.WidthIgnored, "");
        if (flat) ObjectCoordinateSystem.TransformToWorld(record, Shape);
        Finish(record);
    }

    private static bool IsTilted(Vector3D up) => Math.Abs(up.X) > LevelSlope || Math.Abs(up.Y) > LevelSlope;

    private void AddArc(EntityRecord record, double start, double sweep)
    {
        var centre = record.Point(10);
        var radius = record.Required(40);
        if (radius < 0.0) Note(record, DxfRules.NegativeRadius, radius.ToString(CultureInfo.InvariantCulture));
        if (radius == 0.0 || sweep == 0.0) return;
        var arc = new ArcSegment(new Point2D(centre.X, centre.Y), Math.Abs(radius), Angle.FromDegrees(start).Positive(), Angle.FromDegrees(sweep));
        Shape.Add(DrawingPart.Arc(0, arc, centre.Z));
    }

    private double Sweep(EntityRecord record, double start, double end, double turn)
    {
        var span = TurnSpan.Between(start, end, turn);
        if (span.IsWrapped) Note(record, DxfRules.MoreThanOneTurn, (end - start).ToString(CultureInfo.InvariantCulture));
        return span.Sweep;
    }

    private void TakeVertices(EntityRecord record)
    {
        _vertices.Clear();
        _widths.Clear();
        var elevation = record.Number(38, 0.0);
        var wide = record.Number(43, 0.0) != 0.0;
        foreach (var (code, value) in record.Sequence)
        {
            if (code == 10)
            {
                _vertices.Add(new PolylineVertex(value, double.NaN, elevation, 0.0));
                _widths.Add(default);
            }

            if (_vertices.Count == 0) continue;
            ref var vertex = ref CollectionsMarshal.AsSpan(_vertices)[^1];
            if (code == 20) vertex.Y = value;
            else if (code == 42) vertex.Bulge = value;
            else if (code is 40 or 41)
            {
                wide |= value != 0.0;
                _widths[^1] = code == 40 ? (value, _widths[^1].End) : (_widths[^1].Start, value);
            }
        }

        if (wide) Note(record, DxfRules.WidthIgnored, "");
        if (_vertices.Exists(vertex => double.IsNaN(vertex.Y))) record.Refuse(DxfRules.MissingValue, record.Line, Wording.Get("CurveMapper.YOfVertex"));
    }

    /// <summary>The width of a polyline: that at both ends of each of its parts, otherwise the constant one. 0 for none, NaN for one that varies.</summary>
    private double WidthOf(bool closed, double constant)
    {
        var drawn = CollectionsMarshal.AsSpan(_widths)[..Math.Max(0, closed ? _widths.Count : _widths.Count - 1)];
        var (isVaried, isWide) = (false, false);
        foreach (var (start, end) in drawn)
        {
            isWide |= start != 0.0 || end != 0.0;
            isVaried |= start != drawn[0].Start || end != drawn[0].Start;
        }

        return !isWide ? Math.Max(0.0, constant) : isVaried ? double.NaN : Math.Max(0.0, drawn[0].Start);
    }

    /// <summary>Compares group 90 (announced number of vertices) with the vertices read, without relying on it: a damaged file may contain any
    /// number.</summary>
    private void CheckCount(EntityRecord record, bool atEndOfFile)
    {
        var declared = record.Number(90, _vertices.Count);
        if (declared == _vertices.Count) return;
        if (atEndOfFile) record.Refuse(DxfRules.CutRecord, record.Line, "");
        Note(record, DxfRules.VertexCount, Wording.Get("CurveMapper.VerticesDeclaredAndFound", declared, _vertices.Count));
    }

    private void Finish(EntityRecord record)
    {
        if (!Shape.IsInRange) record.Refuse(DxfRules.OutOfRange, record.Line, "");
        if (Shape.Parts.IsEmpty) Note(record, DxfRules.NoLength, Wording.Get("CurveMapper.PointsCoincide"));
        if (record.Warning is { } odd) Shape.Warnings.Add(odd);
        if (record.RepeatedCode != 0) Note(record, DxfRules.RepeatedValue, record.RepeatedCode.ToString(CultureInfo.InvariantCulture));
    }

    private void Note(EntityRecord record, DiagnosticRule rule, string detail) => Shape.Warnings.Add(record.Finding(rule, detail, refused: false));
}

/// <summary>Group 70 of POLYLINE and VERTEX.</summary>
internal static class PolylineFlags
{
    public const int Closed = 1;

    /// <summary>A 3D polyline: vertices in world coordinates, no bulges.</summary>
    public const int InSpace = 8;

    /// <summary>A polygon mesh (16) or a polyface mesh (64).</summary>
    public const int Mesh = 16 | 64;

    /// <summary>On a VERTEX: control point of a spline frame, not drawn.</summary>
    public const int FrameVertex = 16;
}
