using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;
using static Engraver.TestKit.LinetypeDrawing;

namespace Engraver.Core.Tests.Operations;

/// <summary>Two points, one of them at the centre of a circle, a HOLE at 100,50, a BRACKET at 200,50 with a HOLE at 210,50 in it, and a MARK at 7,8.</summary>
public class OperationDrillTests
{
    private static Drawing Drawn => DxfReading.Of(Of([.. Point(5, 5), .. Point(20, 5), (0, "CIRCLE"), (8, "0"), (10, 20.0), (20, 5.00000001), (40, 1.5), .. Insert("HOLE", 100, 50), .. Insert("BRACKET", 200, 50), .. Insert("MARK", 7, 8)]));

    [Theory]
    [InlineData("""{"layers": ["0"]}""", "5 5, 7 8, 20 5, 100 50, 101 50, 210 50, 211 50")]
    [InlineData("\"rest\"", "5 5, 7 8, 20 5, 100 50, 101 50, 210 50, 211 50")]
    [InlineData("""{"handles": ["b1"]}""", "5 5")]
    [InlineData("""{"blocks": ["HOLE"]}""", "100 50, 210 50")]
    [InlineData("""{"blocks": ["BRACKET"]}""", "200 50")]
    [InlineData("""{"blocks": ["mark"], "handles": ["B2"]}""", "7 8, 20 5")]
    [InlineData("""{"blocks": ["HOLE"], "layers": ["0"]}""", "5 5, 7 8, 20 5, 100 50, 210 50")]
    public void Points_circles_and_insertion_points_are_drilled_once(string select, string expected)
    {
        var job = Drilled(select);

        Assert.Empty(job.Assignment.Faults);
        Assert.Equal(expected, string.Join(", ", job.Path.Strokes.Select(stroke => stroke.Start).OrderBy(place => place.X).Select(place => FormattableString.Invariant($"{Math.Round(place.X, 3)} {Math.Round(place.Y, 3)}"))));
        Assert.Empty(job.CheckOf(job.Path));
    }

    [Fact]
    public void The_curves_of_a_block_at_whose_insertion_points_is_drilled_are_taken_by_it()
    {
        var job = new OperationJob(Drawn, """{ "id": "d", "kind": "drill", "select": {"blocks": ["HOLE"]}, "tool": 1, "depth": 1 }, { "id": "e", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1 }""");

        Assert.Empty(job.Assignment.NotTaken);
        Assert.Equal([0, 2], job.Assignment.Parts.Select(part => part.Table.Count));
        Assert.Empty(job.Shapes[0].Findings);
        Assert.Equal(3, NotCutFindings.From(job.Assignment.Drawing, LayerSelection.Default).Counts["POINT"]); // those of the two blocks belong to the drill
    }

    /// <summary>The entities of places are behind those of the drawing and of its texts.</summary>
    [Fact]
    public void A_hole_has_the_entity_of_its_point()
    {
        var job = Drilled("""{"handles": ["B2"], "blocks": ["MARK", "BRACKET"]}""");
        var drawing = job.Assignment.Drawing;

        Assert.Equal(["POINT B2", "LINE", "INSERT"], job.Assignment.Parts[0].Places.Select(place => drawing.Entities[place.EntityIndex].Type.ToDxfName() + " " + drawing.SourceOf(place.EntityIndex).Handle).Select(text => text.Trim()));
        Assert.Equal(Drawn.Entities.Count, job.Assignment.Parts[0].Places[0].EntityIndex);
    }

    [Fact]
    public void Points_that_are_drilled_are_cut_and_the_others_are_not()
    {
        var (drawing, job) = (Drawn, Drilled("""{"handles": ["B1"]}"""));

        Assert.Equal(5, NotCutFindings.From(drawing, LayerSelection.Default).Counts["POINT"]);
        Assert.Equal(4, NotCutFindings.From(job.Assignment.Drawing, LayerSelection.Default).Counts["POINT"]);
    }

    [Fact]
    public void Points_on_a_layer_that_is_off_and_erased_inserts_are_not_drilled()
    {
        var drawing = Drawn;
        var off = drawing with { Layers = [drawing.Layers[0] with { On = false }, .. drawing.Layers.Skip(1)] };
        Assert.Empty(new OperationJob(off, One("""{"handles": ["B1"]}""")).Path.Strokes);

        var without = DrawingEdit.Erase(drawing, [1, 2]); // the HOLE at 100,50
        Assert.Equal([210.0], new OperationJob(without, One("""{"blocks": ["HOLE"]}""")).Path.Strokes.Select(stroke => stroke.Start.X));
    }

    [Fact]
    public void A_hole_elsewhere_or_missing_is_found()
    {
        var job = Drilled("""{"layers": ["0"]}""");
        var path = new EntityTable();
        path.Append(EntitySlots.Of(Segment.FromLine(new Point2D(5, 5.01), new Point2D(5, 5.01)), 0.0), 0, null);

        Assert.Equal(8 + 1 + 1, job.CheckOfShape(job.Shapes[0] with { Path = path }).Count(id => id == "OPR0018")); // circles and places without a hole, the hole, and the number of passes
    }

    private static OperationJob Drilled(string select) => new(Drawn, One(select));

    private static string One(string select) => $$"""{ "id": "d", "kind": "drill", "select": {{select}}, "tool": 1, "depth": 1, "maxDiameter": 3 }""";

    private static (int, object)[] Point(double x, double y) => [(0, "POINT"), (5, x < 10 ? "B1" : "B2"), (8, "0"), (10, x), (20, y)];
}
