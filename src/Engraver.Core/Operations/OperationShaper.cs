using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Kerf;
using Engraver.Core.Offsets;
using Engraver.Core.Offsets.Pieces;
using Engraver.Core.Pockets;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Nesting;

namespace Engraver.Core.Operations;

/// <summary>Makes the path of the tool's centre from the curves of an operation.</summary>
/// <param name="drawing">The drawing of the entity indices.</param>
/// <param name="options">How curves are joined to contours.</param>
/// <param name="maxErrorMm">Largest distance of the arcs that approximate an ellipse or spline.</param>
public sealed class OperationShaper(Drawing drawing, SequencingOptions options, double maxErrorMm)
{
    public ShapedOperation Shape(OperationPart part)
    {
        ArgumentNullException.ThrowIfNull(part);
        if (part.Table.Count + part.Places.Count == 0) return new ShapedOperation(part, EntityTable.Empty, null);
        return part.Operation.Kind switch
        {
            OperationKind.Profile => Profile(part),
            OperationKind.Pocket => OfAreas(part, Pocket),
            OperationKind.Fill => OfAreas(part, Fill),
            OperationKind.Drill => Drill(part),
            _ when part.Operation.CutsDashes => new DashedCurves(drawing, maxErrorMm).Shape(part),
            _ => new ShapedOperation(part, AtHeight(part.Table), null),
        };
    }

    /// <summary>The drawn heights do not count.</summary>
    private static EntityTable AtHeight(EntityTable table)
    {
        var flat = new EntityTable();
        for (var row = 0; row < table.Count; row++) flat.Append(OperationRows.AtHeight(table.CopySlots(row), 0.0, 0.0), table.EntityIndexOf(row), table.CurveOf(row));
        return flat;
    }

    private ShapedOperation Profile(OperationPart part)
    {
        var (operation, chained) = (part.Operation, Sequencer.Chain(AtHeight(part.Table), drawing, options));
        var side = operation.Side switch { ProfileSide.Outside => KerfSide.Outside, ProfileSide.Inside => KerfSide.Inside, ProfileSide.Left => KerfSide.Left, ProfileSide.Right => KerfSide.Right, _ => KerfSide.Nesting };
        var kerf = KerfCompensation.Compensate(chained, new KerfOptions(side, part.Tool.Diameter + (2.0 * operation.Stock), maxErrorMm, options.JoinTolerance, CutsHeights: false));
        var faults = kerf.Diagnostics.Where(finding => finding.Severity == Severity.Error).ToList();
        if (kerf.HasOpenContours) faults.AddRange(chained.Chain.Contours.Where(contour => !contour.Closed).Select(contour => OpenContour(operation, chained, contour)));
        return new ShapedOperation(part, kerf.Table, null) { Findings = [.. chained.Diagnostics, .. kerf.Diagnostics.Where(finding => finding.Severity != Severity.Error && finding.Rule != KerfRules.OpenOnLine)], Faults = faults, Uncut = kerf.Uncut };
    }

    /// <summary>The shape of the contours together, or of each hatch or solid alone: its loops are islands of no other.</summary>
    private ShapedOperation OfAreas(OperationPart part, Func<OperationPart, ShapedOperation> shape)
    {
        if (!part.Operation.TakesHatches) return shape(part);
        var shapes = Enumerable.Range(0, part.Table.Count).GroupBy(row => RecordOf(part.Table.EntityIndexOf(row)))
            .Select(area => shape(part with { Table = part.Table.Picking([.. area]) })).ToList();
        var path = new EntityTable();
        foreach (var one in shapes.Select(one => one.Path))
        {
            for (var row = 0; row < one.Count; row++) path.Append(one.CopySlots(row), one.EntityIndexOf(row), one.CurveOf(row));
        }

        return new ShapedOperation(part, path, shapes.Exists(one => one.Strokes is not null) ? [.. shapes.SelectMany(one => one.Strokes ?? [])] : null)
        {
            Findings = [.. shapes.SelectMany(one => one.Findings)],
            Faults = [.. shapes.SelectMany(one => one.Faults)],
        };

        (int, int) RecordOf(int entity) => (drawing.Entities[entity].SourceLine, drawing.Entities[entity].Insert);
    }

    private ShapedOperation Pocket(OperationPart part)
    {
        var (operation, chained) = (part.Operation, Sequencer.Chain(AtHeight(part.Table), drawing, options));
        var pocket = new PocketOptions
        {
            ToolRadius = part.Tool.Diameter / 2.0,
            Stepover = operation.Stepover,
            Strategy = operation.IsZigzag ? PocketStrategy.Zigzag : PocketStrategy.Contour,
            Angle = Angle.FromDegrees(operation.AngleDegrees),
            FromCentre = true,
            Allowance = 0.0,
            MaxErrorMm = maxErrorMm,
            JoinToleranceMm = options.JoinTolerance,
        };
        var (reduced, unresolved) = Reduced(DrawnContours.From(chained), operation.Stock);
        var result = PocketPlanner.Plan(reduced, pocket);
        var (path, strokes, entities) = (new EntityTable(), new List<int>(), new NearestEntity(chained.Kept));
        foreach (var stroke in result.Strokes)
        {
            foreach (var move in stroke.Moves) path.Append(EntitySlots.Of(move.Segment, 0.0), entities.Of(move.Segment.Start), null);
            strokes.Add(stroke.Moves.Count);
        }

        var findings = PocketFindings.Of(result, pocket).ToLookup(finding => finding.Severity == Severity.Error);
        return new ShapedOperation(part, path, strokes)
        {
            Findings = [.. chained.Diagnostics, .. findings[false].Where(finding => finding.Rule != PocketRules.WithoutInside)],
            Faults = [.. findings[true], .. unresolved.Select(NotCompensated), .. chained.Chain.Contours.Where(contour => !contour.Closed).Select(contour => OpenContour(operation, chained, contour))],
        };
    }

    /// <summary>Largest number of lines of a fill.</summary>
    private const double MostLines = 1e6;

    private ShapedOperation Fill(OperationPart part)
    {
        var (operation, chained) = (part.Operation, Sequencer.Chain(AtHeight(part.Table), drawing, options));
        List<Diagnostic> faults = [.. chained.Chain.Contours.Where(contour => !contour.Closed).Select(contour => OpenContour(operation, chained, contour))];
        var path = new EntityTable();
        var closed = DrawnContours.From(chained).Where(contour => contour.Closed).ToList();
        if (closed.Count == 0 || faults.Count > 0) return new ShapedOperation(part, path, null) { Findings = chained.Diagnostics, Faults = faults };
        var box = chained.Segments.ToArray().Aggregate(Bounds2D.Empty, (bounds, segment) => bounds.Union(segment.Bounds));
        if ((box.Width + box.Height) / operation.Spacing > MostLines) return new ShapedOperation(part, path, null) { Faults = [OperationRules.ValueInvalid.At(default, "spacing", FactText.Of(operation.Spacing), FactText.Of((box.Width + box.Height) / MostLines))] };
        if (operation.Pattern == FillPattern.Contour && Math.Min(box.Width, box.Height) / operation.Spacing > 2.0 * FillContour.Most) return new ShapedOperation(part, path, null) { Faults = [OperationRules.ValueInvalid.At(default, "spacing", FactText.Of(operation.Spacing), FactText.Of(Math.Min(box.Width, box.Height) / (2.0 * FillContour.Most)))] };
        var (entities, clearance, inset) = (new NearestEntity(chained.Kept), new PartClearance(chained.Segments.ToArray()), operation.Inset ?? (part.Tool.Diameter / 2.0));
        foreach (var (line, distance) in operation.Pattern == FillPattern.Contour ? Contours(operation, closed, inset, faults) : Rows(operation, closed, inset, faults))
        {
            path.Append(EntitySlots.Of(line, 0.0), entities.Of(line.Start), null);
            var isParallel = operation.Pattern == FillPattern.Contour;
            if (((Point2D[])[line.Start, line.PointAt(0.5), line.End]).Any(place => clearance.At(place) < distance - (2.0 * maxErrorMm) || (isParallel && clearance.At(place) > distance + (2.0 * maxErrorMm)))) faults.Add(OperationRules.NotAsStated.At(default, operation.Title, Wording.Get("OperationCheck.line"), FactText.Of(line.Start.X), FactText.Of(line.Start.Y)) with { Place = line.Start });
        }

        List<Diagnostic> findings = [.. chained.Diagnostics];
        if (NotFilled(chained, path) is { Count: > 0 } empty) findings.Add(OperationRules.NotFilled.At(default, operation.Title, FactText.Of(empty.Count), FactText.Of(empty[0].X), FactText.Of(empty[0].Y)) with { Place = empty[0] });
        return new ShapedOperation(part, path, null) { Findings = findings, Faults = faults };
    }

    /// <summary>Straight lines of a fill, with their least distance from the contours.</summary>
    private IEnumerable<(Segment Line, double Distance)> Rows(Operation operation, IReadOnlyList<OffsetContour> closed, double inset, List<Diagnostic> faults)
    {
        var reduced = ContourOffset.Offset(closed, inset, OffsetSide.In, OffsetOptions.Round(maxErrorMm));
        faults.AddRange(reduced.Unresolved.Select(NotCompensated));
        List<PathPiece> loops = [.. reduced.Loops.SelectMany(loop => loop.Segments).Where(segment => segment.Length > 0.0).Select(segment => PathPiece.FromSegment(segment))];
        return (operation.IsCross ? (double[])[operation.AngleDegrees, operation.AngleDegrees + 90.0] : [operation.AngleDegrees])
            .SelectMany(angle => ZigzagRows.Across(loops, Angle.FromDegrees(angle), operation.Spacing)).Select(row => (row.Piece.ToSegment(), inset));
    }

    /// <summary>Lines of a fill parallel to the contours, with their distance from these.</summary>
    private IEnumerable<(Segment Line, double Distance)> Contours(Operation operation, IReadOnlyList<OffsetContour> closed, double inset, List<Diagnostic> faults)
    {
        var lines = FillContour.Of(closed, inset, operation.Spacing, maxErrorMm, out var unresolved);
        faults.AddRange(unresolved.Select(NotCompensated));
        return lines.SelectMany(line => line.Segments.Select(segment => (segment, line.Distance)));
    }

    private static Diagnostic NotCompensated(Point2D place) => KerfRules.NotCompensated.At(default, FactText.Of(place.X), FactText.Of(place.Y)) with { Place = place };

    /// <summary>Starts of the contours that should be filled and have no line in them: they are too narrow for the inset or the spacing.</summary>
    private static List<Point2D> NotFilled(ChainedTable chained, EntityTable path)
    {
        var (segments, contours, empty) = (chained.Segments, chained.Chain.Contours, new List<Point2D>());
        Point2D[] middles = [.. Enumerable.Range(0, path.Count).Select(row => path[row].ToSegment().PointAt(0.5))];
        var (lines, drawn, near) = (BoxTree.Build(middles), DrawnContours.From(chained), new List<int>());
        for (var index = 0; index < contours.Count; index++)
        {
            var level = 0;
            for (var around = chained.Inside[index]; around >= 0; around = chained.Inside[around]) level++;
            if (!contours[index].Closed || level % 2 != 0) continue;
            var region = new ContourRegion([.. BiarcFit.FitContour(drawn[index].Segments, CurveError)]);
            near.Clear();
            if (middles.Length > 0) lines.Overlapping(region.Bounds, near);
            if (!near.Exists(line => region.Contains(middles[line]))) empty.Add(contours[index].StartIn(segments.Span));
        }

        return empty;
    }

    /// <summary>Error of the arcs of a curve when it is only asked whether a line is inside of it, mm.</summary>
    private const double CurveError = 1e-3;

    /// <summary>The contours without the material that is left at their walls.</summary>
    private (IReadOnlyList<OffsetContour> Contours, IReadOnlyList<Point2D> Unresolved) Reduced(IReadOnlyList<OffsetContour> drawn, double stock)
    {
        if (stock == 0.0) return (drawn, []);
        var offset = ContourOffset.Offset([.. drawn.Where(contour => contour.Closed)], stock, OffsetSide.In, OffsetOptions.Round(maxErrorMm));
        return ([.. offset.Loops.Select(loop => new OffsetContour(loop.Segments, true))], offset.Unresolved);
    }

    /// <summary>One row without length at the centre of each circle, at each point and insertion point; a place that is named twice is drilled once.</summary>
    private ShapedOperation Drill(OperationPart part)
    {
        var (path, other, places) = (new EntityTable(), new List<int>(), new DistinctPlaces(options.DuplicateTolerance));
        for (var row = 0; row < part.Table.Count; row++)
        {
            var segment = part.Table[row].ToSegment();
            if (segment.Kind != SegmentKind.Circle || 2.0 * segment.Arc.Radius > part.Operation.MaxDiameter) other.Add(row);
            else Add(segment.Arc.Centre, part.Table.EntityIndexOf(row));
        }

        foreach (var (place, entity) in part.Places) Add(place, entity);

        void Add(Point2D place, int entity)
        {
            if (places.Add(place)) path.Append(EntitySlots.Of(Segment.FromLine(place, place), 0.0), entity, null);
        }

        var first = other.Count > 0 ? part.Table[other[0]].StartPoint : default;
        return new ShapedOperation(part, path, [.. Enumerable.Repeat(1, path.Count)])
        {
            Findings = other.Count == 0 ? [] : [OperationRules.NotDrilled.At(drawing.SourceOf(part.Table.EntityIndexOf(other[0])), part.Operation.Title, FactText.Of(other.Count), FactText.Of(first.X), FactText.Of(first.Y)) with { Place = first }],
        };
    }

    private Diagnostic OpenContour(Operation operation, ChainedTable chained, Contour contour)
    {
        var row = contour.Pieces.Span[0].Row;
        var place = contour.StartIn(chained.Segments.Span);
        return OperationRules.OpenContour.At(drawing.SourceOf(chained.Kept.EntityIndexOf(row)), operation.Title, FactText.Of(place.X), FactText.Of(place.Y)) with { Place = place };
    }

    /// <summary>The entity that is nearest to a place.</summary>
    private sealed class NearestEntity(EntityTable table)
    {
        private readonly Segment[] _segments = table.ToSegments();
        private readonly BoxTree _boxes = BoxTree.Build([.. table.ToSegments().Select(segment => segment.Bounds)]);

        public int Of(Point2D place) => table.EntityIndexOf(Math.Max(0, _boxes.Nearest(place, (row, at) => _segments[row].DistanceTo(at), double.PositiveInfinity, out _)));
    }
}
