using Engraver.App.Canvas.Scenes;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;

namespace Engraver.App.Canvas.Picking;

/// <summary>Finds the end, middle, centre, point, quadrant or intersection near the cursor, and the perpendicular, tangent and nearest point of what is
/// under it. Drawing units.</summary>
public static class ObjectSnap
{
    /// <summary>Maximum number of curves that are intersected with each other.</summary>
    private const int MaxCrossedCurves = 48;

    /// <summary>The nearest snap point within the aperture. If nothing is nearer, what is under the cursor offers its centre, perpendicular and tangent at
    /// any distance, and finally its nearest point; null if there is none.</summary>
    /// <param name="kinds">The snaps that are on.</param>
    /// <param name="aperture">Half the side of the snap box.</param>
    /// <param name="from">The previous point, for perpendiculars and tangents; null: none are offered.</param>
    public static SnapPoint? Find(CanvasScene scene, Point2D place, double aperture, SnapKinds kinds, Point2D? from = null)
    {
        ArgumentNullException.ThrowIfNull(scene);
        var search = new SnapSearch(place, aperture);
        var under = new List<Segment>();
        var store = scene.Store;
        foreach (var block in store.BlocksTouching(Bounds2D.FromCorners(place, place).Grown(aperture)))
        {
            foreach (ref readonly var primitive in store.Block(block))
            {
                if (primitive.Entity < scene.Drawing.Entities.Count) Offer(store, primitive, kinds, under, ref search); // not the strokes of letters
            }
        }

        if (kinds.HasFlag(SnapKinds.Node)) OfferPoints(scene.Points, ref search);
        if (kinds.HasFlag(SnapKinds.Intersection)) OfferIntersections(under, ref search);
        return search.Best ?? SnapsUnder(under, kinds, from).OrderBy(snap => snap.Place.DistanceTo(place)).Select(snap => (SnapPoint?)snap).FirstOrDefault() ?? NearestUnder(under, place, kinds);
    }

    private static void Offer(PrimitiveStore store, in ScenePrimitive primitive, SnapKinds kinds, List<Segment> under, ref SnapSearch search)
    {
        if (!store.BoundsOf(primitive).Grown(search.Aperture).Contains(search.Place)) return;
        var segment = store.SegmentOf(primitive);
        foreach (var point in SnapPlaces.Find(segment))
        {
            if (kinds.HasFlag(point.Kind)) search.Offer(point);
        }

        if (segment.DistanceTo(search.Place) <= search.Aperture) under.Add(segment);
    }

    private static void OfferPoints(IReadOnlyList<PlacedPoint> points, ref SnapSearch search)
    {
        for (var i = 0; i < points.Count; i++) search.Offer(new SnapPoint(points[i].Plan, SnapKinds.Node));
    }

    private static void OfferIntersections(List<Segment> under, ref SnapSearch search)
    {
        var count = Math.Min(under.Count, MaxCrossedCurves);
        for (var i = 0; i < count; i++)
        {
            for (var j = i + 1; j < count; j++)
            {
                foreach (var crossing in SegmentCrossings.Find(under[i], under[j])) search.Offer(new SnapPoint(crossing, SnapKinds.Intersection));
            }
        }
    }

    /// <summary>The snap points of the curves under the cursor at any distance.</summary>
    private static IEnumerable<SnapPoint> SnapsUnder(List<Segment> under, SnapKinds kinds, Point2D? from)
    {
        foreach (var segment in under)
        {
            if (kinds.HasFlag(SnapKinds.Centre) && SnapPlaces.CentreOf(segment) is { } centre) yield return new SnapPoint(centre, SnapKinds.Centre);
            if (from is not { } start) continue;
            foreach (var foot in kinds.HasFlag(SnapKinds.Perpendicular) ? SegmentFeet.Perpendicular(segment, start) : []) yield return new SnapPoint(foot, SnapKinds.Perpendicular);
            foreach (var touch in kinds.HasFlag(SnapKinds.Tangent) ? SegmentFeet.Tangent(segment, start) : []) yield return new SnapPoint(touch, SnapKinds.Tangent);
        }
    }

    private static SnapPoint? NearestUnder(List<Segment> under, Point2D place, SnapKinds kinds) => kinds.HasFlag(SnapKinds.Nearest) && under.Count > 0
        ? new SnapPoint(under.Select(segment => PathPlace.Nearest(0, segment, place).At).MinBy(at => at.DistanceTo(place)), SnapKinds.Nearest)
        : null;

    private struct SnapSearch(Point2D place, double aperture)
    {
        private double _distance = double.PositiveInfinity;

        public readonly Point2D Place => place;

        public readonly double Aperture => aperture;

        public SnapPoint? Best { get; private set; }

        /// <summary>The nearest wins; of two at the same point, the one with the lower number (an end before an intersection).</summary>
        public void Offer(SnapPoint point)
        {
            var offset = point.Place - place;
            if (Math.Abs(offset.X) > aperture || Math.Abs(offset.Y) > aperture) return;
            var distance = offset.Length;
            var tie = Math.Abs(distance - _distance) <= 1e-9 * aperture;
            if (tie ? Best is { } best && point.Kind >= best.Kind : distance > _distance) return;
            (Best, _distance) = (point, distance);
        }
    }
}
