using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;

namespace Engraver.Core.Operations;

/// <summary>Divides the curves of an operation into the dashes of their linetypes. A polyline has the pattern of each of its parts, or one pattern through all
/// of them (PLINEGEN). Letters, and curves whose linetype has no gaps, are cut whole.</summary>
/// <param name="maxErrorMm">Largest distance of the arcs that approximate an ellipse or spline.</param>
internal sealed class DashedCurves(Drawing drawing, double maxErrorMm)
{
    /// <summary>Largest number of dashes of an operation.</summary>
    private const double MostDashes = 1e6;

    /// <summary>Pieces of a dash that are shorter are rounding, mm.</summary>
    private const double Shortest = 1e-9;

    /// <summary>Rounding of a whole curve, as a fraction of it.</summary>
    private const double Whole = 1e-12;

    private readonly Dictionary<int, DashPattern?> _patterns = [];

    public ShapedOperation Shape(OperationPart part)
    {
        var (path, gaps, dashed, marks) = (new EntityTable(), 0.0, new HashSet<int>(), 0.0);
        foreach (var (entity, isClosed, rows) in RunsOf(part.Table))
        {
            if (PatternOf(entity) is not { } pattern)
            {
                foreach (var row in rows) path.Append(OperationRows.AtHeight(part.Table.CopySlots(row), 0.0, 0.0), entity, part.Table.CurveOf(row));
                continue;
            }

            List<Segment> segments = [.. BiarcFit.FitContour(rows.Select(row => part.Table[row].ToSegment()), maxErrorMm)];
            var length = segments.Sum(segment => segment.Length);
            marks += 1.0 + (length / pattern.Period * pattern.Dashes);
            if (marks > MostDashes) return new ShapedOperation(part, new EntityTable(), null) { Faults = [OperationRules.ValueInvalid.At(drawing.SourceOf(entity), part.Operation.Id + ": dashes", FactText.Of(pattern.Period), FactText.Of(MostDashes))] };
            var before = path.Count;
            Append(path, segments, pattern.Along(length, isClosed), entity);
            dashed.Add(entity);
            gaps += length;
            for (var row = before; row < path.Count; row++) gaps -= path[row].ToSegment().Length;
        }

        return new ShapedOperation(part, path, null) { Findings = [.. FindingsOf(part, dashed, gaps)] };
    }

    private IEnumerable<Diagnostic> FindingsOf(OperationPart part, HashSet<int> dashed, double gaps)
    {
        if (dashed.Count == 0)
        {
            yield return OperationRules.NoDashes.At(default, part.Operation.Title);
            yield break;
        }

        yield return OperationRules.GapsLeft.At(default, part.Operation.Title, FactText.Of(dashed.Count), FactText.Of(Math.Round(gaps, 3)));
        foreach (var entity in dashed.Order().DistinctBy(drawing.LinetypeOf))
        {
            var linetype = drawing.Linetypes[drawing.LinetypeOf(entity)];
            if (linetype.HasShapes) yield return OperationRules.ShapesNotCut.At(drawing.SourceOf(entity), part.Operation.Title, linetype.Name);
        }

        foreach (var entity in dashed.Order().Where(entity => PatternOf(entity)!.SmallestGap <= part.Tool.Diameter).DistinctBy(drawing.LinetypeOf))
        {
            yield return OperationRules.GapsClosed.At(drawing.SourceOf(entity), part.Operation.Title, drawing.Linetypes[drawing.LinetypeOf(entity)].Name, FactText.Of(PatternOf(entity)!.SmallestGap), FactText.Of(part.Tool.Diameter));
        }
    }

    /// <summary>The rows along which one pattern runs, in the order of the table.</summary>
    private IEnumerable<(int Entity, bool IsClosed, List<int> Rows)> RunsOf(EntityTable table)
    {
        for (var row = 0; row < table.Count;)
        {
            var (entity, rows) = (table.EntityIndexOf(row), new List<int>());
            var runsThrough = drawing.LineStyles[drawing.Entities[entity].LineStyle].RunsThrough;
            do rows.Add(row++);
            while (runsThrough && row < table.Count && table.EntityIndexOf(row) == entity);
            yield return (entity, rows.Count > 1 ? drawing.Entities[entity].Closed : table[rows[0]].ToSegment().IsClosed, rows);
        }
    }

    /// <summary>The pattern of an entity; null when it is cut whole.</summary>
    private DashPattern? PatternOf(int entity)
    {
        if (_patterns.TryGetValue(entity, out var known)) return known;
        var scale = drawing.Scale.ToMillimetres(drawing.LinetypeScale * drawing.LineStyles[drawing.Entities[entity].LineStyle].Scale);
        return _patterns[entity] = drawing.Entities[entity].Type.IsLetters() ? null : DashPattern.Of(drawing.Linetypes[drawing.LinetypeOf(entity)], scale);
    }

    private static void Append(EntityTable path, List<Segment> segments, IEnumerable<(double From, double To)> dashes, int entity)
    {
        var (index, start) = (0, 0.0); // the segment in which the next dash begins, and its distance from the start of the run
        foreach (var (from, to) in dashes)
        {
            while (index + 1 < segments.Count && from >= start + segments[index].Length) start += segments[index++].Length;
            for (var (i, at) = (index, start); i < segments.Count && at < to; at += segments[i++].Length)
            {
                var length = segments[i].Length;
                var (first, last) = (Math.Max(0.0, from - at), Math.Min(length, to - at));
                if (last - first > Shortest) path.Append(EntitySlots.Of(Piece(segments[i], first / length, last / length), 0.0), entity, null);
            }
        }
    }

    /// <summary>A part of a line, arc or circle; where it is not cut, its ends remain exactly.</summary>
    private static Segment Piece(in Segment segment, double from, double to)
    {
        if (from <= Whole && to >= 1.0 - Whole) return segment;
        var (start, end) = (from <= Whole ? segment.Start : segment.PointAt(from), to >= 1.0 - Whole ? segment.End : segment.PointAt(to));
        if (segment.Kind == SegmentKind.Line) return Segment.FromLine(start, end);
        var arc = segment.Arc;
        return Segment.FromArc(new ArcSegment(arc.Centre, arc.Radius, arc.Start + (arc.Sweep * from), arc.Sweep * (to - from)), start, end);
    }
}
