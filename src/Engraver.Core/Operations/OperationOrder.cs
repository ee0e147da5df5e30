using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Sequencing.Ordering.Optimising;

namespace Engraver.Core.Operations;

/// <summary>The strokes of the operations in the order of cutting: operation after operation, and within each as the sequencer orders contours. Holes follow
/// the nearest one or are in the optimal order, pockets in the order of their passes.</summary>
public static class OperationOrder
{
    /// <summary>Join tolerance of a computed path, whose ends coincide except for rounding, mm.</summary>
    private const double ExactJoint = 1e-6;

    /// <param name="shapes">In the order of the operations.</param>
    /// <param name="drawing">The drawing of the entity indices.</param>
    /// <param name="options">Tolerances, order, and start and end of the tool.</param>
    /// <param name="search">The search for the optimal order of each operation, when it starts; null: that of the options.</param>
    public static IReadOnlyList<OrderedOperation> Of(IReadOnlyList<ShapedOperation> shapes, Drawing drawing, SequencingOptions options, Func<OrderSearch>? search = null)
    {
        ArgumentNullException.ThrowIfNull(shapes);
        ArgumentNullException.ThrowIfNull(options);
        var (ordered, tool) = (new List<OrderedOperation>(), options.ToolStart);
        var last = shapes.LastOrDefault(shape => shape.Path.Count > 0);
        foreach (var shape in shapes)
        {
            if (shape.Path.Count == 0)
            {
                ordered.Add(new OrderedOperation(shape, shape.Path, []));
                continue;
            }

            var own = options with { ToolStart = tool, ToolEnd = shape == last ? options.ToolEnd : null, Search = search?.Invoke() ?? options.Search };
            var one = shape.Strokes is null ? Sequenced(shape, drawing, own) : Planned(shape, own);
            ordered.Add(one);
            if (one.Strokes is [.., var stroke]) tool = one.Path[stroke.FirstRow + stroke.Rows - 1].EndPoint;
        }

        return ordered;
    }

    private static OrderedOperation Sequenced(ShapedOperation shape, Drawing drawing, SequencingOptions options)
    {
        // A tool path meets exactly, and its segments may be shorter than the join tolerance.
        var exact = shape.Operation.Kind switch
        {
            OperationKind.Fill when shape.Operation.Pattern == FillPattern.Lines => options with { KeepDuplicates = true, ArcTolerance = null, JoinTolerance = 0.0 },
            OperationKind.Profile or OperationKind.Fill => options with { KeepDuplicates = true, ArcTolerance = null, JoinTolerance = Math.Min(options.JoinTolerance, ExactJoint) },
            _ when shape.Operation.CutsDashes => options with { ArcTolerance = null, JoinTolerance = Math.Min(options.JoinTolerance, ExactJoint) },
            _ => options,
        };
        var sequence = Sequencer.Sequence(shape.Path, drawing, exact);
        var (strokes, row) = (new List<OrderedStroke>(), 0);
        foreach (var stroke in sequence.Strokes)
        {
            strokes.Add(new OrderedStroke(row, stroke.Moves.Count, stroke.Closed, stroke.Inside));
            row += stroke.Moves.Count;
        }

        var path = shape.Operation is { Kind: OperationKind.Profile, Direction: not CutDirection.Any } ? Directed(sequence.Table, strokes, shape.Operation) : sequence.Table;
        return new OrderedOperation(shape, path, strokes) { Reversed = sequence.Reversed, DuplicatesRemoved = sequence.DuplicatesRemoved, Diagnostics = shape.Operation.Kind == OperationKind.Fill || shape.Operation.CutsDashes ? [] : sequence.Diagnostics };
    }

    /// <summary>The closed strokes of a profile in the direction that leaves the wall on the right (climb) or on the left.</summary>
    private static EntityTable Directed(EntityTable table, List<OrderedStroke> strokes, Operation operation)
    {
        var path = new EntityTable();
        for (var index = 0; index < strokes.Count; index++)
        {
            var stroke = strokes[index];
            var isOutside = operation.Side switch { ProfileSide.Outside => true, ProfileSide.Inside => false, _ => LevelOf(index, strokes) % 2 == 0 };
            var isClockwise = isOutside == (operation.Direction == CutDirection.Climb);
            var isTurned = stroke.Closed && operation.Side is not (ProfileSide.Left or ProfileSide.Right) && AreaOf(table, stroke) < 0.0 != isClockwise;
            for (var step = 0; step < stroke.Rows; step++)
            {
                var row = isTurned ? stroke.FirstRow + stroke.Rows - 1 - step : stroke.FirstRow + step;
                var slots = table.CopySlots(row);
                if (isTurned) slots.Reverse();
                path.Append(slots, table.EntityIndexOf(row), isTurned ? table.CurveOf(row)?.Reversed() : table.CurveOf(row));
            }
        }

        return path;
    }

    /// <summary>Number of strokes around a stroke.</summary>
    private static int LevelOf(int index, List<OrderedStroke> strokes)
    {
        var level = 0;
        for (var around = strokes[index].Inside; around >= 0; around = strokes[around].Inside) level++;
        return level;
    }

    /// <summary>Twice the signed area of the chords of a closed stroke, arcs divided; positive counter-clockwise.</summary>
    private static double AreaOf(EntityTable table, OrderedStroke stroke)
    {
        const int chords = 16;
        var (area, origin) = (0.0, table[stroke.FirstRow].StartPoint);
        for (var row = stroke.FirstRow; row < stroke.FirstRow + stroke.Rows; row++)
        {
            var segment = table[row].ToSegment();
            var count = segment.Kind == SegmentKind.Line ? 1 : chords;
            for (var i = 0; i < count; i++)
            {
                var (from, to) = (segment.PointAt((double)i / count) - origin, segment.PointAt((i + 1.0) / count) - origin);
                area += (from.X * to.Y) - (from.Y * to.X);
            }
        }

        return area;
    }

    /// <summary>Strokes as planned; those of a drill from hole to nearest hole, or in the optimal order.</summary>
    private static OrderedOperation Planned(ShapedOperation shape, SequencingOptions options)
    {
        if (shape.Operation.Kind == OperationKind.Drill) return Drilled(shape, options);
        var (strokes, row) = (new List<OrderedStroke>(), 0);
        foreach (var rows in shape.Strokes!)
        {
            strokes.Add(new OrderedStroke(row, rows, shape.Path[row].StartPoint == shape.Path[row + rows - 1].EndPoint, -1));
            row += rows;
        }

        return new OrderedOperation(shape, shape.Path, strokes);
    }

    private static OrderedOperation Drilled(ShapedOperation shape, SequencingOptions options)
    {
        Point2D[] holes = [.. Enumerable.Range(0, shape.Path.Count).Select(row => shape.Path[row].StartPoint)];
        var order = NearestHoles(holes, options.ToolStart);
        if (options.Order == StrokeOrder.Optimal) order = OptimalOrder.OfPlaces(holes, order, options);
        return new OrderedOperation(shape, shape.Path.Picking([.. order]), [.. order.Select((_, index) => new OrderedStroke(index, 1, false, -1))]);
    }

    private static IReadOnlyList<int> NearestHoles(Point2D[] holes, Point2D tool)
    {
        var (left, order) = (BoxTree.Build(holes), new List<int>());
        while (left.Nearest(tool, (hole, from) => holes[hole].DistanceTo(from), double.PositiveInfinity, out _) is >= 0 and var next)
        {
            left.Hide(next);
            order.Add(next);
            tool = holes[next];
        }

        return order;
    }
}
