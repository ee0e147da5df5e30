using System.Globalization;
using System.Xml.Linq;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Plots;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Plots;

public class SvgPlotWriterTests
{
    [Fact]
    public void A_picture_of_the_path_numbers_every_stroke_and_shows_rapids_and_start()
    {
        var picture = PathPicture(new DrawingBuilder().Square(10, 10, 50).Circle(30, 30, 5).Line(0, 90, 50, 90));

        Assert.Equal(["1", "2", "3"], Elements(picture, "text").Where(text => Class(text) == "number").Select(text => text.Value));
        Assert.Equal(2, Elements(picture, "path").Count(path => Class(path) == "cut closed" && !IsLegend(path)));
        Assert.Single(Elements(picture, "path"), path => Class(path) == "cut open" && !IsLegend(path));
        Assert.Single(Elements(picture, "path"), path => Class(path) == "rapid" && !IsLegend(path));
        Assert.Single(Elements(picture, "circle"), circle => Class(circle) == "start");
    }

    [Fact]
    public void A_picture_of_the_drawing_has_no_order()
    {
        var picture = DrawingPicture(new DrawingBuilder().Square(10, 10, 50).Circle(30, 30, 5));

        Assert.DoesNotContain(Elements(picture, "text"), text => Class(text) == "number");
        Assert.DoesNotContain(Elements(picture, "circle"), circle => Class(circle) == "start");
    }

    [Fact]
    public void Y_points_up_and_a_counter_clockwise_arc_has_sweep_flag_zero()
    {
        var arc = Curve(DrawingPicture(new DrawingBuilder().Arc(0, 0, 10, 0, 90)));
        var upright = Curve(DrawingPicture(new DrawingBuilder().Line(0, 0, 0, 10)));

        Assert.Matches(@"^M[\d.,]+A[\d.]+,[\d.]+ 0 0 0 [\d.,]+A[\d.]+,[\d.]+ 0 0 0 [\d.,]+$", arc);
        var ys = upright[1..].Split('L').Select(pair => double.Parse(pair.Split(',')[1], CultureInfo.InvariantCulture)).ToList();
        Assert.True(ys[0] > ys[1]);
    }

    [Fact]
    public void The_caption_tells_the_size_in_millimetres_and_escapes_the_name()
    {
        var picture = DrawingPicture(new DrawingBuilder().Line(0, 0, 30, 40), "a<b> & \u0001c");

        Assert.Contains(Elements(picture, "text"), text => text.Value == "a<b> & c   30 x 40 mm");
    }

    [Theory]
    [InlineData(1e-3)]
    [InlineData(1e6)]
    public void The_picture_has_the_same_size_for_a_tiny_and_a_huge_drawing(double scale)
    {
        var picture = DrawingPicture(new DrawingBuilder().Square(5 * scale, 5 * scale, scale));

        Assert.Equal("1288", picture.Root!.Attribute("width")!.Value);
        Assert.Equal("M44,1244L1244,1244L1244,44L44,44L44,1244", Curve(picture));
    }

    [Fact]
    public void Numbers_are_thinned_out_when_there_are_many()
    {
        var builder = new DrawingBuilder();
        for (var i = 0; i < 1000; i++) builder.Circle(i % 40 * 10, i / 40 * 10, 3);

        var numbers = Elements(PathPicture(builder), "text").Count(text => Class(text) == "number");

        Assert.InRange(numbers, 100, 300);
    }

    [Fact]
    public void Nothing_to_show_is_still_a_picture() =>
        Assert.Contains(Elements(PathPicture(new DrawingBuilder()), "text"), text => text.Value.StartsWith("0 strokes", StringComparison.Ordinal));

    private static EntityTable Analysed(DrawingBuilder builder) => ArcAnalysis.Analyse(EntityTableBuilder.Build(builder.Build(), LayerSelection.Default));

    private static XDocument DrawingPicture(DrawingBuilder builder, string title = "drawing.dxf") => Written(PlotModel.FromDrawing(Analysed(builder), title));

    private static XDocument PathPicture(DrawingBuilder builder) =>
        Written(PlotModel.FromPath(ToolpathPlanner.Plan(Sequencer.Sequence(Analysed(builder), null, UsualOptions.Sequencing), Point2D.Origin, 0.001), "drawing.dxf"));

    private static XDocument Written(PlotModel plot)
    {
        using var text = new StringWriter();
        SvgPlotWriter.Write(plot, text);
        return XDocument.Parse(text.ToString());
    }

    private static List<XElement> Elements(XDocument picture, string name) => [.. picture.Descendants().Where(element => element.Name.LocalName == name)];

    private static string? Class(XElement element) => element.Attribute("class")?.Value;

    private static bool IsLegend(XElement path) => path.Attribute("stroke-width") is not null;

    private static string Curve(XDocument picture) => Elements(picture, "path").First(path => Class(path)!.StartsWith("cut", StringComparison.Ordinal)).Attribute("d")!.Value;
}
