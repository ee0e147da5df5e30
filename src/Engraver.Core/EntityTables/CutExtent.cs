using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.EntityTables;

/// <summary>Extent of the curves that are cut, in plan and in height; millimetres.</summary>
/// <param name="Bounds">Smallest box in plan; empty when no curve is cut.</param>
/// <param name="Low">The lowest height.</param>
/// <param name="High">The highest.</param>
/// <param name="Levels">Number of different heights, as the tolerance distinguishes them; 0 when no curve is cut.</param>
/// <param name="Slanted">The curves that rise or fall.</param>
/// <param name="Tolerance">Heights that differ by no more are equal.</param>
internal sealed record CutExtent(Bounds2D Bounds, double Low, double High, int Levels, CutExtent.Slant Slanted, double Tolerance)
{
    public static CutExtent From(Drawing drawing, LayerSelection selection, double tolerance)
    {
        var survey = new Survey(drawing, tolerance);
        var taken = selection.Taken(drawing.Layers);
        for (var entity = 0; entity < drawing.Entities.Count; entity++)
        {
            if (!drawing.Entities[entity].Hidden && taken[drawing.Entities[entity].Layer] && !drawing.IsAreaOnly(drawing.Entities[entity].Type)) survey.Add(entity);
        }

        return survey.ToExtent();
    }

    /// <summary>Curves that rise or fall.</summary>
    /// <param name="First">The first one's index in the drawing.</param>
    /// <param name="Low">Its lowest height.</param>
    /// <param name="High">Its highest.</param>
    public readonly record struct Slant(int Count, int First, double Low, double High);

    private sealed class Survey(Drawing drawing, double tolerance)
    {
        private readonly DrawingScale _scale = drawing.Scale;
        private readonly HashSet<double> _heights = [];
        private Bounds2D _bounds = Bounds2D.Empty;
        private Slant _slanted;

        public void Add(int index)
        {
            ref var entity = ref drawing.Entities[index];
            var (low, high) = (double.PositiveInfinity, double.NegativeInfinity);
            for (var i = entity.FirstPart; i < entity.FirstPart + entity.PartCount; i++)
            {
                ref var part = ref drawing.Parts[i];
                if (part.Kind == SegmentKind.Line && part.A == part.D && part.B == part.E) continue; // not cut: it has no length in plan
                var (from, to) = HeightsOf(part);
                (low, high) = (Math.Min(low, Math.Min(from, to)), Math.Max(high, Math.Max(from, to)));
                AddPlan(part);
            }

            if (low > high) return;
            _heights.Add(low);
            _heights.Add(high);
            if (high - low > tolerance) _slanted = _slanted.Count == 0 ? new Slant(1, index, low, high) : _slanted with { Count = _slanted.Count + 1 };
        }

        public CutExtent ToExtent()
        {
            double[] ascending = [.. _heights.Order()];
            return ascending.Length == 0
                ? new CutExtent(Bounds2D.Empty, 0.0, 0.0, 0, default, tolerance)
                : new CutExtent(_bounds, ascending[0], ascending[^1], EndHeights.Levels(ascending, tolerance), _slanted, tolerance);
        }

        private void AddPlan(in DrawingPart part)
        {
            if (part.Kind == SegmentKind.Line)
            {
                _bounds = _bounds.Including(_scale.ToMillimetres(new Point2D(part.A, part.B))).Including(_scale.ToMillimetres(new Point2D(part.D, part.E)));
                return;
            }

            _bounds = _bounds.Union(_scale.ToMillimetres(drawing.SegmentOf(part).Bounds));
        }

        /// <summary>Lowest and highest height; of a curve those of its control points, which enclose it.</summary>
        private (double, double) HeightsOf(in DrawingPart part)
        {
            if (!part.IsFreeCurve) return part.Kind == SegmentKind.Line ? (_scale.ToMillimetres(part.C), _scale.ToMillimetres(part.F)) : (_scale.ToMillimetres(part.C), _scale.ToMillimetres(part.C));
            var (low, high) = (double.PositiveInfinity, double.NegativeInfinity);
            foreach (var span in drawing.Curves[part.CurveIndex].Spans)
            {
                for (var i = 0; i <= span.Degree; i++) (low, high) = (Math.Min(low, span.Z(i)), Math.Max(high, span.Z(i)));
            }

            return (_scale.ToMillimetres(low), _scale.ToMillimetres(high));
        }
    }
}
