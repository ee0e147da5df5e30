using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>Compares the dashes of an operation with the drawing by other formulas than those that make them: of an open curve only whole patterns of gaps are
/// left out, of a closed one the same part as in the pattern; every piece is on its curve, and an open curve begins and ends on a dash.</summary>
public static class DashCheck
{
    /// <summary>Rounding of a length, as a part of it; an ellipse or spline is measured along its arcs.</summary>
    private const double Rounding = 1e-7;
    private const double RoundingOfCurve = 1e-5;

    /// <param name="drawing">The drawing of the entity indices.</param>
    /// <param name="maxError">Largest distance of a piece from its curve, mm.</param>
    public static IReadOnlyList<Diagnostic> Findings(IReadOnlyList<ShapedOperation> shapes, Drawing drawing, double maxError)
    {
        ArgumentNullException.ThrowIfNull(shapes);
        ArgumentNullException.ThrowIfNull(drawing);
        return [.. shapes.Where(shape => shape.Operation.CutsDashes && shape.Faults.Count == 0).SelectMany(shape => Findings(shape, drawing, maxError))];
    }

    private static IEnumerable<Diagnostic> Findings(ShapedOperation shape, Drawing drawing, double maxError)
    {
        var drawn = ByEntity(shape.Part.Table);
        var cut = ByEntity(shape.Path);
        foreach (var (entity, curves) in drawn)
        {
            var pieces = cut.GetValueOrDefault(entity, []);
            var isWrong = pieces.Count == 0 || Math.Abs(pieces.Sum(piece => piece.Length) - ExpectedOf(drawing, entity, curves)) > (curves.Exists(curve => curve.IsFreeCurve) ? RoundingOfCurve : Rounding) * (1.0 + curves.Sum(curve => curve.Length));
            var ends = EndsOf(drawing, entity, curves).ToList();
            isWrong |= pieces.Exists(piece => ((Point2D[])[piece.Start, piece.PointAt(0.5), piece.End]).Any(place => FromNearest(curves, place) > maxError * 1.01));
            isWrong |= ends.Exists(end => FromNearest(pieces, end) > maxError * 1.01);
            if (isWrong) yield return OperationRules.NotAsStated.At(drawing.SourceOf(entity), shape.Operation.Title, Wording.Get("OperationCheck.dash"), FactText.Of(curves[0].Start.X), FactText.Of(curves[0].Start.Y)) with { Place = curves[0].Start };
        }
    }

    private static Dictionary<int, List<Segment>> ByEntity(EntityTable table)
    {
        var rows = new Dictionary<int, List<Segment>>();
        for (var row = 0; row < table.Count; row++)
        {
            if (!rows.TryGetValue(table.EntityIndexOf(row), out var segments)) rows[table.EntityIndexOf(row)] = segments = [];
            segments.Add(table[row].ToSegment());
        }

        return rows;
    }

    private static bool RunsThrough(Drawing drawing, int entity, List<Segment> curves) => curves.Count > 1 && drawing.LineStyles[drawing.Entities[entity].LineStyle].RunsThrough;

    /// <summary>The ends that are on dashes: of the whole polyline, or of each of its parts.</summary>
    private static IEnumerable<Point2D> EndsOf(Drawing drawing, int entity, List<Segment> curves) => RunsThrough(drawing, entity, curves)
        ? drawing.Entities[entity].Closed ? [] : [curves[0].Start, curves[^1].End]
        : curves.Where(curve => !curve.IsClosed).SelectMany(curve => (Point2D[])[curve.Start, curve.End]);

    private static double FromNearest(List<Segment> segments, Point2D place) => segments.Min(segment => segment.DistanceTo(place));

    /// <summary>The length that is cut of an entity.</summary>
    private static double ExpectedOf(Drawing drawing, int entity, List<Segment> curves)
    {
        var linetype = drawing.Linetypes[drawing.LinetypeOf(entity)];
        var unit = drawing.Scale.ToMillimetres(1.0) * drawing.LinetypeScale * drawing.LineStyles[drawing.Entities[entity].LineStyle].Scale;
        var (whole, gaps) = (linetype.PatternLength * unit, -linetype.Elements.Where(element => element < 0.0).Sum() * unit);
        if (gaps == 0.0 || gaps >= whole && !linetype.Elements.Contains(0.0) || drawing.Entities[entity].Type.IsLetters()) return curves.Sum(curve => curve.Length);
        return RunsThrough(drawing, entity, curves)
            ? CutOf(curves.Sum(curve => curve.Length), drawing.Entities[entity].Closed)
            : curves.Sum(curve => CutOf(curve.Length, curve.IsClosed));

        double CutOf(double length, bool isClosed)
        {
            if (length < whole * (1.0 - 1e-9)) return length;
            var startsWithDot = linetype.Elements.First(element => element >= 0.0) == 0.0;
            var isStretched = isClosed || startsWithDot;
            var patterns = isStretched ? Math.Max(1.0, Math.Round(length / whole)) : Math.Floor((length / whole) + 1e-9);
            var stretch = isStretched ? length / (patterns * whole) : 1.0;
            var dots = (patterns * linetype.Elements.Count(element => element == 0.0)) + (startsWithDot && !isClosed ? 1.0 : 0.0);
            var dot = Math.Min(DashPattern.DotLength, -linetype.Elements.Where(element => element < 0.0).Max() * unit * stretch / 2.0);
            return length - (patterns * gaps * stretch) + (dots * dot);
        }
    }
}
