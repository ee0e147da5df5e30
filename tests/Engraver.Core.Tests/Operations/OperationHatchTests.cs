using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Operations;

/// <summary>A square of 40 on layer CUT with a circle of radius 8 around its centre; on FILL a hatch of 20 with an island of 6 at 100,0, and a triangle as
/// SOLID at 200,0; on NOTES a hatch of 5.</summary>
public class OperationHatchTests
{
    private static readonly DxfText s_text = DxfText.WithEntities([.. Square("LWPOLYLINE", "CUT", 0, 0, 40), (0, "CIRCLE"), (8, "CUT"), (10, 20.0), (20, 20.0), (40, 8.0),
        (0, "HATCH"), (8, "FILL"), (10, 0.0), (20, 0.0), (30, 0.0), (2, "SOLID"), (70, 1), (71, 0), (91, 2), .. Loop(100, 0, 20), .. Loop(107, 7, 6), (75, 0), (76, 1), (98, 0),
        (0, "SOLID"), (8, "FILL"), (10, 200.0), (20, 0.0), (11, 230.0), (21, 0.0), (12, 215.0), (22, 30.0), (13, 215.0), (23, 30.0),
        (0, "HATCH"), (8, "NOTES"), (10, 0.0), (20, 0.0), (30, 0.0), (2, "ANSI31"), (70, 0), (71, 0), (91, 1), .. Loop(300, 0, 5), (75, 0), (76, 1), (98, 0)]);

    [Theory]
    [InlineData("fill", ", \"spacing\": 1")]
    [InlineData("pocket", "")]
    public void The_areas_of_hatches_and_solids_are_machined_around_their_islands(string kind, string fields)
    {
        var job = new OperationJob(Read(), $$"""{ "id": "a", "kind": "{{kind}}", "select": {"layers": ["FILL"]}, "tool": 2, "depth": 1, "hatches": true{{fields}} }, { "id": "e", "kind": "engrave", "select": "rest", "tool": 2, "depth": 1 }""");
        var places = job.Path.Strokes.Zip(job.Passes.Strokes).Where(pair => pair.Second.Operation.Id == "a").SelectMany(pair => OperationJob.PointsOf(pair.First, 0.2)).ToList();

        Assert.Empty(job.Assignment.Faults);
        Assert.Empty(job.Shapes[0].Faults);
        Assert.All(places, place => Assert.True((InSquare(place, 100.5, 0.5, 119.5, 19.5) && FromIsland(place) >= 0.499) || (place.X > 200 && place.Y > 0.49 && place.Y < 30), $"{place}"));
        Assert.Equal([true, true, true, true], ((Point2D[])[new(103, 10), new(117, 3), new(110, 18), new(215, 10)]).Select(place => places.Min(place.DistanceTo) < 0.8));
        Assert.Equal([5], job.Assignment.Parts.Skip(1).Select(part => part.Table.Count)); // the curves of CUT: hatches are not the rest
        Assert.Equal(["HATCH 1"], NotCutFindings.From(job.Assignment.Drawing, LayerSelection.Default).Counts.Select(pair => $"{pair.Key} {pair.Value}"));
        Assert.Empty(job.CheckOf(job.Path));
    }

    [Fact]
    public void Without_the_outlines_the_operation_is_a_fault()
    {
        const string fill = """{ "id": "a", "kind": "fill", "select": {"layers": ["FILL"]}, "tool": 2, "depth": 1, "hatches": true, "spacing": 1 }""";

        Assert.Equal("OPR0047", Assert.Single(new OperationJob(DxfReading.Of(s_text), fill).Assignment.Faults).Id);
        Assert.Empty(new OperationJob(Read(CutChoice.Hatch | CutChoice.Solid, CutChoice.None), fill).Assignment.Faults);
    }

    [Fact]
    public void Areas_that_are_read_for_operations_are_not_cut_otherwise()
    {
        var (plain, read) = (DxfReading.Of(s_text), Read());

        Assert.Equal(EntityTableBuilder.Build(plain, LayerSelection.Default).Count, EntityTableBuilder.Build(read, LayerSelection.Default).Count);
        Assert.Equal(NotCutFindings.From(plain, LayerSelection.Default).Counts, NotCutFindings.From(read, LayerSelection.Default).Counts);
        Assert.Equal(plain.Balance.Construction, read.Balance.Construction);
    }

    private static Drawing Read(CutChoice cut = CutChoice.None, CutChoice areas = CutChoice.Hatch | CutChoice.Solid) => DxfReading.Of(s_text.ToAscii(), new DxfReadOptions(Cut: cut) { Areas = areas });

    private static double FromIsland(Point2D place) => double.Hypot(Math.Max(0.0, Math.Abs(place.X - 110.0) - 3.0), Math.Max(0.0, Math.Abs(place.Y - 10.0) - 3.0));

    private static bool InSquare(Point2D place, double x1, double y1, double x2, double y2) => place.X > x1 - 1e-6 && place.X < x2 + 1e-6 && place.Y > y1 - 1e-6 && place.Y < y2 + 1e-6;

    private static (int, object)[] Square(string type, string layer, double x, double y, double side) =>
        [(0, type), (8, layer), (90, 4), (70, 1), (10, x), (20, y), (10, x + side), (20, y), (10, x + side), (20, y + side), (10, x), (20, y + side)];

    private static (int, object)[] Loop(double x, double y, double side) =>
        [(92, 3), (72, 0), (73, 1), (93, 4), (10, x), (20, y), (10, x + side), (20, y), (10, x + side), (20, y + side), (10, x), (20, y + side), (97, 0)];
}
