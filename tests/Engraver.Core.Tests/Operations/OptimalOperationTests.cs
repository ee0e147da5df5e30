using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Operations;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Sequencing.Ordering.Optimising;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;
using static Engraver.TestKit.LinetypeDrawing;

namespace Engraver.Core.Tests.Operations;

/// <summary>Five points on a line and three strokes above them: the nearest first leads away and back.</summary>
public class OptimalOperationTests
{
    private const string Drill = """{ "id": "d", "kind": "drill", "select": {"handles": ["B1", "B2", "B3", "B4", "B5"]}, "tool": 1, "depth": 1 }""";
    private const string Engrave = """{ "id": "e", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1 }""";

    private static Drawing Drawn => DxfReading.Of(Of([.. Point("B1", 1), .. Point("B2", -1.5), .. Point("B3", 4), .. Point("B4", -7), .. Point("B5", 14), .. Circle(-6, 30), .. Circle(1, 30), .. Circle(5, 30)]));

    [Fact]
    public void Holes_are_drilled_in_the_order_of_the_least_travel()
    {
        var (nearest, optimal) = (Ordered(Drill, StrokeOrder.Nearest), Ordered(Drill, StrokeOrder.Optimal));

        Assert.Equal([1.0, -1.5, 4.0, 14.0, -7.0], StartsOf(nearest[0]).Select(place => place.X));
        Assert.Equal(42.0, Travel(optimal), 1e-9); // to one side, to the other, and back
    }

    [Fact]
    public void An_operation_is_ordered_from_the_end_of_the_one_before()
    {
        var ordered = Ordered(Drill + ", " + Engrave, StrokeOrder.Optimal);

        Assert.Equal(["d", "e"], ordered.Select(one => one.Shape.Operation.Id));
        Assert.Equal([5, 3], ordered.Select(one => one.Strokes.Count));
        Assert.Equal(14.0, StartsOf(ordered[0]).Last().X); // the tool need not return between operations
        Assert.Equal([5.0, 1.0, -6.0], StartsOf(ordered[1]).Select(place => Math.Round(place.X)));
    }

    [Fact]
    public void Each_operation_has_its_own_search()
    {
        var searches = 0;
        var job = new OperationJob(Drawn, Drill + ", " + Engrave);

        OperationOrder.Of(job.Shapes, job.Assignment.Drawing, UsualOptions.Sequencing with { Order = StrokeOrder.Optimal }, () =>
        {
            searches++;
            return OrderSearch.Default;
        });

        Assert.Equal(2, searches);
    }

    private static IReadOnlyList<OrderedOperation> Ordered(string operations, StrokeOrder order)
    {
        var job = new OperationJob(Drawn, operations);
        return OperationOrder.Of(job.Shapes, job.Assignment.Drawing, UsualOptions.Sequencing with { Order = order, ToolEnd = default(Point2D) });
    }

    private static double Travel(IReadOnlyList<OrderedOperation> ordered)
    {
        var (sum, tool) = (0.0, default(Point2D));
        foreach (var place in ordered.SelectMany(StartsOf)) (sum, tool) = (sum + tool.DistanceTo(place), place);
        return sum + tool.DistanceTo(default);
    }

    private static IEnumerable<Point2D> StartsOf(OrderedOperation one) => one.Strokes.Select(stroke => one.Path[stroke.FirstRow].StartPoint);

    private static (int, object)[] Point(string handle, double x) => [(0, "POINT"), (5, handle), (8, "0"), (10, x), (20, 0.0)];

    private static (int, object)[] Circle(double x, double y) => [(0, "CIRCLE"), (8, "0"), (10, x), (20, y), (40, 0.25)];
}
