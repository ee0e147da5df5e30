using System.Text.Json;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Trajectories;

namespace Engraver.Workbench.Sidecars;

/// <summary>A trajectory as an entry of the file. Its error bound is verified again when it is read.</summary>
internal static class TrajectoryEntry
{
    private static readonly (string Word, OffsetSide Side)[] s_sides = [("left", OffsetSide.Left), ("right", OffsetSide.Right), ("in", OffsetSide.In), ("out", OffsetSide.Out)];

    public static SidecarTrajectoryJson ToJson(DocumentTrajectory one)
    {
        var curve = one.Curve;
        return new SidecarTrajectoryJson
        {
            Name = one.Name,
            Closed = curve.Closed,
            Z = curve.Z,
            MaxError = one.MaxErrorMm,
            SegmentLength = one.SegmentLengthMm,
            Handles = [.. one.Handles],
            Made = ToJson(one.Origin),
            VerifiedBound = curve.VerifiedBound,
            Length = curve.Length,
            Lines = [.. curve.Lines.Select((place, i) => curve.Heights is { } heights ? new[] { place.X, place.Y, heights[i] } : [place.X, place.Y])],
            Knots = [.. curve.Knots],
            Source = [.. curve.Source.Select(ToJson)],
            Others = new Dictionary<string, JsonElement>(one.Others),
        };
    }

    /// <exception cref="JsonException">It is incomplete or contradicts itself.</exception>
    public static DocumentTrajectory FromJson(SidecarTrajectoryJson json, string where)
    {
        if (json.Name is null || !DocumentTrajectory.IsName(json.Name)) throw SidecarText.InvalidFile(where + ".name");
        if (!(json.MaxError > 0.0) || json.SegmentLength is <= 0.0) throw SidecarText.InvalidFile(where + ".maxError");
        var rows = json.Lines ?? throw SidecarText.InvalidFile(where + ".lines");
        var inSpace = rows.Length > 0 && rows[0] is { Length: 3 };
        if (rows.Any(row => row is null || row.Length != (inSpace ? 3 : 2))) throw SidecarText.InvalidFile(where + ".lines");
        Segment[] source = [.. (json.Source ?? throw SidecarText.InvalidFile(where + ".source")).Select((segment, i) => FromJson(segment, $"{where}.source[{i}]"))];
        var curve = TrajectoryProof.Prove([.. rows.Select(row => new Point2D(row[0], row[1]))], json.Knots ?? [], source, json.Closed, inSpace ? [.. rows.Select(row => row[2])] : null);
        if (curve is null) throw SidecarText.InvalidFile(where + ".knots");
        return new DocumentTrajectory(json.Name, inSpace ? curve : curve with { Z = json.Z }, json.MaxError)
        {
            SegmentLengthMm = json.SegmentLength,
            Handles = json.Handles ?? [],
            Origin = OriginOf(json.Made, where + ".made"),
            Others = [.. json.Others ?? []],
        };
    }

    private static TrajectoryOriginJson? ToJson(TrajectoryOrigin? origin) => origin is null ? null
        : new(origin.Group, origin.Index, origin.Count, origin.SourceFingerprint, origin.Offset, origin.Offset is null ? null : s_sides.First(side => side.Side == origin.Side).Word, SidecarText.CornersWord(origin.Corners));

    private static TrajectoryOrigin? OriginOf(TrajectoryOriginJson? json, string where)
    {
        if (json is null) return null;
        if (json is not { Group: >= 0, Index: >= 0, Drawn: { Length: > 0 } drawn, Offset: null or > 0.0 } || json.Count <= json.Index) throw SidecarText.InvalidFile(where);
        var side = s_sides.Where(side => side.Word == json.Side).Select(side => (OffsetSide?)side.Side).FirstOrDefault();
        if (side is null && json.Offset is not null) throw SidecarText.InvalidFile(where + ".side");
        return new TrajectoryOrigin(json.Group, json.Index, json.Count, drawn) { Offset = json.Offset, Side = side ?? default, Corners = SidecarText.CornersOf(json.Corners, where + ".corners") };
    }

    private static SegmentJson ToJson(Segment segment)
    {
        if (segment.IsFreeCurve)
        {
            double[][] spans = [.. segment.Curve.Spans.ToArray().Select(span => span.Homogeneous.ToArray())];
            return segment.Kind == SegmentKind.Ellipse ? new SegmentJson { Ellipse = spans } : new SegmentJson { Spline = spans };
        }

        if (segment.Kind == SegmentKind.Line) return new SegmentJson { Line = [segment.Start.X, segment.Start.Y, segment.End.X, segment.End.Y] };
        var arc = segment.Arc;
        return new SegmentJson { Arc = [arc.Centre.X, arc.Centre.Y, arc.Radius, arc.Start.Degrees, arc.Sweep.Degrees, segment.Start.X, segment.Start.Y, segment.End.X, segment.End.Y] };
    }

    private static Segment FromJson(SegmentJson? json, string where) => json switch
    {
        { Line: [var x1, var y1, var x2, var y2] } => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2)),
        { Arc: [var x, var y, > 0.0 and var radius, var start, (not 0.0) and (>= -360.0 and <= 360.0) and var sweep, var x1, var y1, var x2, var y2] } =>
            ArcOf(new ArcSegment(new Point2D(x, y), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep)), new Point2D(x1, y1), new Point2D(x2, y2), where),
        { Ellipse: { Length: > 0 } spans } => CurveOf(SegmentKind.Ellipse, spans, where),
        { Spline: { Length: > 0 } spans } => CurveOf(SegmentKind.Spline, spans, where),
        _ => throw SidecarText.InvalidFile(where),
    };

    /// <summary>Checks the end points, because wrong ones would invalidate the error bound.</summary>
    private static Segment ArcOf(ArcSegment arc, Point2D start, Point2D end, string where)
    {
        var near = 1e-9 * (1.0 + arc.Radius + Math.Abs(arc.Centre.X) + Math.Abs(arc.Centre.Y));
        return arc.StartPoint.IsNear(start, near) && arc.EndPoint.IsNear(end, near) ? Segment.FromArc(arc, start, end) : throw SidecarText.InvalidFile(where);
    }

    private static Segment CurveOf(SegmentKind kind, double[][] spans, string where)
    {
        const int HighestDegree = 24;
        foreach (var span in spans)
        {
            if (span is null || span.Length % BezierSpan.Stride != 0 || span.Length / BezierSpan.Stride is < 2 or > HighestDegree + 1) throw SidecarText.InvalidFile(where);
            for (var i = BezierSpan.Stride - 1; i < span.Length; i += BezierSpan.Stride) if (!(span[i] > 0.0)) throw SidecarText.InvalidFile(where);
        }

        return Segment.FromCurve(new RationalCurve(kind, [.. spans.Select(span => new BezierSpan(span))]));
    }
}
