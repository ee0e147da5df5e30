using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Reshaping;

/// <summary>FILLET and CHAMFER on two lines that meet at 0,0, a square and a circle.</summary>
public class FilletCommandTests
{
    private static DrawingBuilder Angle() => new DrawingBuilder().Line(0, 0, 20, 0).Line(0, 20, 0, 0);

    [Fact]
    public async Task The_radius_is_asked_for_once_and_kept()
    {
        await using var talk = ObjectText.Talk(Angle().Line(50, 0, 70, 0).Line(50, 20, 50, 0));
        await talk.TypeAsync("F", "R", "5", "10,0", "0,10", "FILLET", "60,0", "50,10");

        Assert.Equal(["Line: 5,0>20,0", "Line: 0,20>0,5"], ObjectText.All(talk)[..2]);
        Assert.Equal(["Arc: 5,5 r5 270-90", "Arc: 55,5 r5 270-90"], ObjectText.All(talk)[4..]);
        Assert.Contains("radius 5.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Who_misses_the_second_object_need_not_pick_the_first_one_again()
    {
        await using var talk = ObjectText.Talk(Angle());
        await talk.TypeAsync("F", "R", "5", "10,0", "90,90");
        Assert.StartsWith("Select second object", talk.Session.Prompt.Text, StringComparison.Ordinal);
        Assert.Contains("No object at this point", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("0,10");

        Assert.Equal(["Line: 5,0>20,0", "Line: 0,20>0,5", "Arc: 5,5 r5 270-90"], ObjectText.All(talk));
    }

    [Fact]
    public async Task Radius_0_and_Shift_make_a_corner()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(5, 0, 20, 0).Line(0, 20, 0, -7));
        await talk.TypeAsync("FILLET", "R", "3", "10,0", "shift:0,10");

        Assert.Equal(["Line: 0,0>20,0", "Line: 0,20>0,0"], ObjectText.All(talk));
    }

    [Fact]
    public async Task Without_trim_only_the_arc_comes()
    {
        await using var talk = ObjectText.Talk(Angle());
        await talk.TypeAsync("FILLET", "T", "N", "R", "5", "10,0", "0,10");

        Assert.Equal(["Line: 0,0>20,0", "Line: 0,20>0,0", "Arc: 5,5 r5 270-90"], ObjectText.All(talk));
    }

    [Fact]
    public async Task Multiple_goes_on_and_is_one_step()
    {
        await using var talk = ObjectText.Talk(Angle().Line(20, 20, 0, 20));
        await talk.TypeAsync("FILLET", "R", "2", "M", "10,0", "0,10", "0,15", "10,20", "U", "0,15", "10,20", "");
        Assert.Equal(5, talk.State.Drawing!.Entities.Count);
        Assert.Equal("Line: 0,18>0,2", ObjectText.All(talk)[1]);
        await talk.TypeAsync("U");

        Assert.Equal(["Line: 0,0>20,0", "Line: 0,20>0,0", "Line: 20,20>0,20"], ObjectText.All(talk));
    }

    [Fact]
    public async Task All_corners_of_a_polyline()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Square(0, 0, 10));
        await talk.TypeAsync("FILLET", "R", "2", "P", "5,0");

        Assert.Equal("LwPolyline closed: 2,0>8,0 | 8,2 r2 270+90 | 10,2>10,8 | 8,8 r2 0+90 | 8,10>2,10 | 2,8 r2 90+90 | 0,8>0,2 | 2,2 r2 180+90", ObjectText.All(talk)[0]);
        Assert.Contains("4 corners rounded, 0 left unchanged", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Corners_without_room_are_left_and_counted()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Square(0, 0, 10));
        await talk.TypeAsync("FILLET", "R", "6", "P", "5,0");

        Assert.Contains("2 corners rounded, 2 left unchanged", talk.Said, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("5,0", "10,5")]
    [InlineData("10,5", "5,0")]
    public async Task One_corner_of_a_polyline_in_either_order(string first, string second)
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Square(0, 0, 10));
        await talk.TypeAsync("FILLET", "R", "2", first, second);

        Assert.Equal("LwPolyline closed: 0,0>8,0 | 8,2 r2 270+90 | 10,2>10,10 | 10,10>0,10 | 0,10>0,0", ObjectText.All(talk)[0]);
    }

    [Fact]
    public async Task The_seam_of_a_closed_polyline_is_a_corner_like_any_other()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Square(0, 0, 10));
        await talk.TypeAsync("FILLET", "R", "2", "5,0", "0,5");

        Assert.Equal("LwPolyline closed: 2,0>10,0 | 10,0>10,10 | 10,10>0,10 | 0,10>0,2 | 2,2 r2 180+90", ObjectText.All(talk)[0]);
    }

    [Fact]
    public async Task The_arc_is_on_the_layer_of_both_or_on_the_current_one()
    {
        var deep = new Layer("DEEP", On: true, Frozen: false, Plot: true);
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 20, 0).OnLayer(deep).Line(0, 20, 0, 0).Line(40, 0, 20, 0));
        await talk.TypeAsync("FILLET", "R", "2", "10,0", "0,10", "FILLET", "0,15", "30,0");
        Assert.Equal(["0", "DEEP"], new[] { 3, 4 }.Select(index => talk.State.Drawing!.Layers[talk.State.Drawing.Entities[index].Layer].Name));
    }

    [Fact]
    public async Task What_cannot_be_joined_is_told_and_asked_again()
    {
        await using var talk = ObjectText.Talk(Angle().Square(40, 0, 8).Free(FreeCurves.Ellipse(80, 0, 10, 0.5, 0, 0, 360).ToCurve()));
        await talk.TypeAsync("FILLET", "R", "30", "10,0", "0,10", "10,0", "12,0", "10,0", "44,0", "10,0", "90,0", "200,200");

        Assert.Contains("corner cannot be made", talk.Said, StringComparison.Ordinal);
        Assert.Contains("same segment", talk.Said, StringComparison.Ordinal);
        Assert.Contains("EXPLODE", talk.Said, StringComparison.Ordinal);
        Assert.Contains("No object at this point", talk.Said, StringComparison.Ordinal);
        Assert.Equal("Line: 0,0>20,0", ObjectText.All(talk)[0]);
        await talk.Session.CancelAsync();
        Assert.Equal(PromptView.Idle, talk.Session.Prompt);
    }

    [Fact]
    public async Task The_arc_is_seen_before_the_second_click()
    {
        await using var talk = ObjectText.Talk(Angle());
        await talk.TypeAsync("FILLET", "R", "5", "10,0");

        Assert.Equal(new Point2D(5, 5), Assert.Single(talk.Session.Prompt.PointRequest!.Ghost!(new Point2D(0, 10))).Arc.Centre);
        await talk.Session.CancelAsync();
    }

    [Fact]
    public async Task Chamfers_of_two_lines_and_of_a_polyline()
    {
        await using var talk = ObjectText.Talk(Angle().Square(40, 0, 10));
        await talk.TypeAsync("CHA", "D", "3", "4", "10,0", "0,10", "CHAMFER", "D", "2", "", "P", "45,0");

        Assert.Equal(["Line: 3,0>20,0", "Line: 0,20>0,4", "LwPolyline closed: 42,0>48,0 | 48,0>50,2 | 50,2>50,8 | 50,8>48,10 | 48,10>42,10 | 42,10>40,8 | 40,8>40,2 | 40,2>42,0", "Line: 3,0>0,4"], ObjectText.All(talk));
    }
}
