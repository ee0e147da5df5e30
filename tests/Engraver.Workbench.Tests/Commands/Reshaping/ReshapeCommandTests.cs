using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Reshaping;

/// <summary>BREAK, STRETCH, MATCHPROP.</summary>
public class ReshapeCommandTests
{
    [Fact]
    public async Task Break_takes_out_what_lies_between_two_places()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0).Circle(20, 0, 5));
        await talk.TypeAsync("BR", "3,0", "7,1", "BREAK", "20,5", "F", "25,0", "20,5");

        Assert.Equal(["Line: 0,0>3,0", "Line: 7,0>10,0", "Arc: 20,0 r5 90+270"], ObjectText.All(talk));
    }

    [Fact]
    public async Task Break_parts_an_object_at_one_place()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0).Square(20, 0, 8).Circle(50, 0, 5));
        await talk.TypeAsync("BREAK", "3,0", "@", "BREAK", "24,0", "@");

        Assert.Equal(["Line: 0,0>3,0", "Line: 3,0>10,0", "LwPolyline: 24,0>28,0 | 28,0>28,8 | 28,8>20,8 | 20,8>20,0 | 20,0>24,0"], ObjectText.All(talk)[..3]);
        Assert.Contains("two different points", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("BREAK", "55,0", "@")).Message, StringComparison.Ordinal);
        Assert.Contains("No object at this point", Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("BREAK", "99,99")).Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Break_beyond_the_end_takes_the_rest_but_never_all()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
        await talk.TypeAsync("BREAK", "4,0", "19,0");
        Assert.Equal(["Line: 0,0>4,0"], ObjectText.All(talk));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("BREAK", "2,0", "F", "-5,0", "19,0"));
        Assert.Equal(["Line: 0,0>4,0"], ObjectText.All(talk));
    }

    [Fact]
    public async Task Stretch_moves_the_ends_in_the_box_and_whole_what_lies_in_it()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0).Square(8, 2, 8).Circle(12, 0.5, 0.25).Line(0, 20, 5, 20));
        await talk.TypeAsync("S", "C", "9,-1", "18,12", "", "0,0", "5,1");

        Assert.Equal(["Line: 0,0>15,1", "LwPolyline closed: 8,2>21,3 | 21,3>21,11 | 21,11>8,10 | 8,10>8,2", "Circle closed: 17,1.5 r0.25 0+360", "Line: 0,20>5,20"], ObjectText.All(talk));
        await talk.TypeAsync("U");
        Assert.Equal("Line: 0,0>10,0", ObjectText.All(talk)[0]);
    }

    /// <summary>A polyline's arc keeps its bulge; a single arc its height over the chord: radius 5 over 10, moved to a chord of 20, has h = 5 and r =
    /// (h^2 + 10^2) / 2h = 12.5.</summary>
    [Fact]
    public async Task Stretched_arcs_keep_bulge_or_height()
    {
        var arc = Segment.FromArc(ArcSegment.FromBulge(new Point2D(0, 0), new Point2D(10, 0), -1.0));
        await using var talk = ObjectText.Talk(new DrawingBuilder().Arc(5, 30, 5, 0, 180).Curve(CurveType.LwPolyline, Segment.FromLine(new Point2D(-5, 0), new Point2D(0, 0)), arc));
        await talk.TypeAsync("STRETCH", "C", "9,29", "11,31", "C", "9,-1", "11,1", "", "D", "10,0");

        Assert.Equal(["Arc: 10,22.5 r12.5 36.869898+106.260205", "LwPolyline: -5,0>0,0 | 10,0 r10 180-180"], ObjectText.All(talk));
    }

    [Fact]
    public async Task Stretch_to_a_point_is_refused_and_a_curve_that_is_only_crossed_stays()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0).Circle(20, 0, 5));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("STRETCH", "C", "9,-1", "11,1", "", "0,0", "-10,0"));
        await talk.TypeAsync("STRETCH", "26,1", "24,-1", "", "0,0", "7,7");

        Assert.Equal(["Line: 0,0>10,0", "Circle closed: 20,0 r5 0+360"], ObjectText.All(talk));
        Assert.Contains("1 object not stretched: no end point in a crossing window", talk.Said, StringComparison.Ordinal);
    }

    /// <summary>As in COPY and MOVE: Enter at "Specify displacement" repeats the previous one.</summary>
    [Fact]
    public async Task Stretch_remembers_its_displacement()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
        await talk.TypeAsync("STRETCH", "C", "9,-1", "11,1", "", "D", "2.5,1");
        await talk.TypeAsync("STRETCH", "C", "12,0", "13,2", "", "D", "");

        Assert.Equal(["Line: 0,0>15,2"], ObjectText.All(talk));
    }

    [Fact]
    public async Task Stretch_is_seen_before_the_click()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
        await talk.TypeAsync("STRETCH", "C", "9,-1", "11,1", "", "0,0");

        Assert.Equal([Segment.FromLine(new Point2D(0, 0), new Point2D(13, 4))], talk.Session.Prompt.PointRequest!.Ghost!(new Point2D(3, 4)));
        await talk.Session.CancelAsync();
    }

    [Fact]
    public async Task Match_gives_layer_and_colour_until_Enter_as_one_step()
    {
        var deep = new Layer("DEEP", On: true, Frozen: false, Plot: true);
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0).Line(0, 5, 10, 5).OnLayer(deep).Line(0, 10, 10, 10));
        var steps = talk.Session.Document.UndoNames.Count();
        await talk.TypeAsync("MA", "5,10", "5,0", "5,5", "");

        Assert.Equal(["DEEP", "DEEP", "DEEP"], Layers(talk));
        Assert.Equal(steps + 1, talk.Session.Document.UndoNames.Count());
        await talk.TypeAsync("U");
        Assert.Equal(["0", "0", "DEEP"], Layers(talk));
        await talk.TypeAsync("MATCHPROP", "5,10", "S", "Color", "5,0", "");
        Assert.Equal(["0", "0", "DEEP"], Layers(talk));
    }

    private static IEnumerable<string> Layers(CommandTestSession talk) => Enumerable.Range(0, talk.State.Drawing!.Entities.Count).Select(index => talk.State.Drawing!.Layers[talk.State.Drawing.Entities[index].Layer].Name);
}
