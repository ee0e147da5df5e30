using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>The figures of a drawing, in drawing units, all layers, hidden curves included.</summary>
/// <param name="Leaf">Curves after expansion by the type they were written as; types that do not occur are missing. A curve without length counts.</param>
/// <param name="Primitives">Lines, arcs and so on, parts of polylines included.</param>
/// <param name="Length">Lengths by kind; a whole-turn ARC counts as arc, whatever a block's scale makes of a curve.</param>
/// <param name="Bounds">Tight box in plan (true extremes of arcs), null when no curve has an extent.</param>
public sealed record DrawingSummary(IReadOnlyDictionary<CurveType, int> Leaf, PrimitiveCounts Primitives, CurveLengths Length, Bounds2D? Bounds)
{
    public static DrawingSummary Of(Drawing drawing)
    {
        var leaf = new int[Enum.GetValues<CurveType>().Length];
        var lengths = new double[leaf.Length];
        int polylineLines = 0, polylineArcs = 0;
        var plan = 0.0;
        var bounds = Bounds2D.Empty;
        for (var i = 0; i < drawing.Entities.Count; i++)
        {
            ref var entity = ref drawing.Entities[i];
            leaf[(int)entity.Type]++;
            for (var p = entity.FirstPart; p < entity.FirstPart + entity.PartCount; p++)
            {
                ref var part = ref drawing.Parts[p];
                var kind = KindOf(entity.Type, part.Kind);
                if (IsPolyline(entity.Type) && kind == CurveType.Line) polylineLines++;
                if (IsPolyline(entity.Type) && kind == CurveType.Arc) polylineArcs++;
                var inPlan = part.InPlan();
                lengths[(int)kind] += part.SpaceLength;
                plan += inPlan.Length;
                bounds = bounds.Union(inPlan.Bounds);
            }
        }

        int Count(CurveType type) => leaf[(int)type];
        double Length(CurveType type) => lengths[(int)type];
        return new DrawingSummary(
            Enum.GetValues<CurveType>().Where(type => Count(type) > 0).ToDictionary(type => type, Count),
            new PrimitiveCounts(
                Count(CurveType.Line) + polylineLines,
                Count(CurveType.Arc) + polylineArcs,
                Count(CurveType.Circle),
                Count(CurveType.Ellipse),
                Count(CurveType.Spline),
                Count(CurveType.LwPolyline) + Count(CurveType.Polyline),
                drawing.Balance.Points),
            new CurveLengths(Length(CurveType.Line), Length(CurveType.Arc), Length(CurveType.Circle), Length(CurveType.Ellipse), Length(CurveType.Spline), plan),
            bounds.IsEmpty ? null : bounds);
    }

    private static bool IsPolyline(CurveType type) => type is CurveType.LwPolyline or CurveType.Polyline;

    private static CurveType KindOf(CurveType type, SegmentKind part) => !IsPolyline(type) ? type : part == SegmentKind.Line ? CurveType.Line : CurveType.Arc;
}
