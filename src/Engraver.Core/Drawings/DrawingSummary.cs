using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>Counts, lengths and extents of a drawing, in drawing units, over all layers, hidden curves included.</summary>
/// <param name="Leaf">Curves after expansion by the type as which they were written; types that do not occur are missing. A curve without length
/// counts.</param>
/// <param name="Primitives">Lines, arcs and other elements, parts of polylines included.</param>
/// <param name="Length">Lengths by kind; a whole-turn ARC counts as arc, whatever a block's scale makes of a curve.</param>
/// <param name="Bounds">Smallest box in plan (true extremes of every curve); null when no curve has an extent.</param>
public sealed record DrawingSummary(IReadOnlyDictionary<CurveType, int> Leaf, PrimitiveCounts Primitives, CurveLengths Length, Bounds2D? Bounds)
{
    public static DrawingSummary From(Drawing drawing)
    {
        var tally = new Tally();
        for (var i = 0; i < drawing.Entities.Count; i++) tally.Add(ref drawing.Entities[i], drawing);
        return tally.ToSummary(drawing.Balance.Points);
    }

    private sealed class Tally
    {
        private static readonly CurveType[] Types = Enum.GetValues<CurveType>();
        private readonly int[] _curves = new int[Types.Length];
        private readonly int[] _polylineParts = new int[Types.Length];
        private readonly double[] _lengths = new double[Types.Length];
        private double _planLength;
        private Bounds2D _bounds = Bounds2D.Empty;

        public void Add(ref DrawingEntity entity, Drawing drawing)
        {
            _curves[(int)entity.Type]++;
            var isComposed = entity.Type >= CurveType.LwPolyline;
            for (var i = entity.FirstPart; i < entity.FirstPart + entity.PartCount; i++)
            {
                ref var part = ref drawing.Parts[i];
                var kind = isComposed ? TypeOf(part.Kind, entity.Type) : entity.Type;
                if (isComposed) _polylineParts[(int)kind]++;
                if (part.Kind == SegmentKind.Line)
                {
                    AddLine(part, ref _lengths[(int)kind]);
                    continue;
                }

                var inPlan = drawing.SegmentOf(part);
                _lengths[(int)kind] += drawing.SpaceLengthOf(part);
                _planLength += inPlan.Length;
                _bounds = _bounds.Union(inPlan.Bounds);
            }
        }

        /// <summary>A fast method for lines, of which most drawings consist.</summary>
        private void AddLine(in DrawingPart line, ref double length)
        {
            var (x, y, z) = (line.D - line.A, line.E - line.B, line.F - line.C);
            var squared = (x * x) + (y * y);
            _planLength += Math.Sqrt(squared);
            length += Math.Sqrt(squared + (z * z));
            _bounds = _bounds.Including(new Point2D(line.A, line.B)).Including(new Point2D(line.D, line.E));
        }

        public DrawingSummary ToSummary(int points) => new(
            Types.Where(type => _curves[(int)type] > 0).ToDictionary(type => type, type => _curves[(int)type]),
            new PrimitiveCounts(
                Pieces(CurveType.Line),
                Pieces(CurveType.Arc),
                Pieces(CurveType.Circle),
                Pieces(CurveType.Ellipse),
                Pieces(CurveType.Spline),
                Pieces(CurveType.LwPolyline) + Pieces(CurveType.Polyline),
                points),
            new CurveLengths(
                Length(CurveType.Line), Length(CurveType.Arc), Length(CurveType.Circle), Length(CurveType.Ellipse), Length(CurveType.Spline), _planLength),
            _bounds.IsEmpty ? null : _bounds);

        /// <summary>The type as which a part of a polyline or an outline is counted. An arc of a polyline remains an arc, even if a block's scale has made an
        /// ellipse of it.</summary>
        private static CurveType TypeOf(SegmentKind kind, CurveType whole) => kind switch
        {
            SegmentKind.Line => CurveType.Line,
            SegmentKind.Ellipse when whole > CurveType.Polyline => CurveType.Ellipse,
            SegmentKind.Spline => CurveType.Spline,
            _ => CurveType.Arc,
        };

        private int Pieces(CurveType type) => _curves[(int)type] + _polylineParts[(int)type];

        private double Length(CurveType type) => _lengths[(int)type];
    }
}

/// <summary>Numbers of curves: the lines and arcs of polylines are counted, and the polylines themselves.</summary>
/// <param name="Point">POINT entities, which are not curves.</param>
public sealed record PrimitiveCounts(int Line, int Arc, int Circle, int Ellipse, int Spline, int Polyline, int Point);

/// <summary>Lengths by kind, along the curves in space, drawing units. The straight parts of polylines count as lines, their bulge parts as arcs.</summary>
/// <param name="PlanTotal">Length of all curves, in plan.</param>
public sealed record CurveLengths(double Line, double Arc, double Circle, double Ellipse, double Spline, double PlanTotal)
{
    public double Total => Line + Arc + Circle + Ellipse + Spline;
}
