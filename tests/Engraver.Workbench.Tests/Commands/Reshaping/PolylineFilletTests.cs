using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Workbench.Tests.Commands.Reshaping;

/// <summary>FILLET and CHAMFER where a polyline is one of the two objects, or both. Expected corners and centres were computed by hand.</summary>
public class PolylineFilletTests
{
    private static readonly Point2D[] s_zigzag = [new(0, 0), new(20, 0), new(20, 20), new(0, 20)];

    /// <summary>With an open polyline the other object becomes one polyline, in the polyline's direction; parts beyond the joint are removed.</summary>
    [Theory]
    [InlineData("R 4", "20,10", "30,30", "LwPolyline: 0,0>20,0 | 20,0>20,26 | 24,26 r4 180-90 | 24,30>40,30")]
    [InlineData("R 4", "30,30", "20,10", "LwPolyline: 0,0>20,0 | 20,0>20,26 | 24,26 r4 180-90 | 24,30>40,30")]
    [InlineData("R 0", "20,10", "30,30", "LwPolyline: 0,0>20,0 | 20,0>20,30 | 20,30>40,30")]
    [InlineData("R 3", "-10,30", "5,0", "LwPolyline: -10,40>-10,3 | -7,3 r3 180+90 | -7,0>20,0 | 20,0>20,20 | 20,20>0,20")]
    public async Task A_line_and_a_part_of_an_open_polyline_become_one(string radius, string first, string second, string expected)
    {
        await using var talk = ObjectText.Talk(Polyline(s_zigzag).Line(40, 30, 24, 30).Line(-10, 25, -10, 40));
        var before = ObjectText.All(talk);
        await talk.TypeAsync(["FILLET", .. radius.Split(' '), first, second]);

        Assert.Equal(2, talk.State.Drawing!.Entities.Count);
        Assert.Equal(expected, ObjectText.All(talk)[0]);
        Assert.Equal("A1", talk.State.Drawing.SourceOf(0).Handle);
        await talk.TypeAsync("U");
        Assert.Equal(before, ObjectText.All(talk));
    }

    [Fact]
    public async Task Two_open_polylines_become_one_and_the_first_one_keeps_its_handle()
    {
        await using var talk = ObjectText.Talk(Polyline(new(0, 0), new(20, 0)).Curve(CurveType.LwPolyline, Segment.FromLine(new(50, 40), new(30, 40)), Segment.FromLine(new(30, 40), new(30, 10))));
        await talk.TypeAsync("FILLET", "R", "5", "10,0", "30,20");

        Assert.Equal(["LwPolyline: 0,0>25,0 | 25,5 r5 270+90 | 30,5>30,40 | 30,40>50,40"], ObjectText.All(talk));
        Assert.Equal("A1", talk.State.Drawing!.SourceOf(0).Handle);
    }

    [Fact]
    public async Task A_part_between_two_lines_of_a_polyline_gives_way_to_the_new_one()
    {
        await using var talk = ObjectText.Talk(Polyline(new(0, 0), new(10, 0), new(12, 2), new(12, 12)));
        await talk.TypeAsync("FILLET", "R", "3", "5,0", "12,8");
        Assert.Equal("LwPolyline: 0,0>9,0 | 9,3 r3 270+90 | 12,3>12,12", ObjectText.All(talk)[0]);
        await talk.TypeAsync("CHAMFER", "D", "2", "4", "5,0", "12,8");
        Assert.Equal("LwPolyline: 0,0>10,0 | 10,0>12,4 | 12,4>12,12", ObjectText.All(talk)[0]);
        await talk.TypeAsync("FILLET", "R", "0", "12,8", "5,0");
        Assert.Equal("LwPolyline: 0,0>12,0 | 12,0>12,12", ObjectText.All(talk)[0]);
    }

    [Theory]
    [InlineData("0", "LwPolyline closed: 0,0>20,0 | 20,0>20,20 | 20,20>0,20 | 0,20>0,0")]
    [InlineData("2", "LwPolyline closed: 2,0>20,0 | 20,0>20,20 | 20,20>0,20 | 0,20>0,2 | 2,2 r2 180+90")]
    public async Task The_last_and_the_first_part_of_an_open_polyline_close_it(string radius, string expected)
    {
        await using var talk = ObjectText.Talk(Polyline(new(10, 0), new(20, 0), new(20, 20), new(0, 20), new(0, 10)));
        await talk.TypeAsync("FILLET", "R", radius, "15,0", "0,15");

        Assert.Equal(expected, ObjectText.All(talk)[0]);
    }

    [Fact]
    public async Task All_corners_get_the_new_radius_and_radius_0_takes_the_arcs_away()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Square(0, 0, 10));
        await talk.TypeAsync("FILLET", "R", "1", "P", "5,0", "FILLET", "R", "3", "P", "5,0");
        Assert.Equal("LwPolyline closed: 3,0>7,0 | 7,3 r3 270+90 | 10,3>10,7 | 7,7 r3 0+90 | 7,10>3,10 | 3,7 r3 90+90 | 0,7>0,3 | 3,3 r3 180+90", ObjectText.All(talk)[0]);
        await talk.TypeAsync("FILLET", "R", "0", "P", "5,0");
        Assert.Equal("LwPolyline closed: 0,0>10,0 | 10,0>10,10 | 10,10>0,10 | 0,10>0,0", ObjectText.All(talk)[0]);
    }

    [Fact]
    public async Task A_closed_polyline_stays_whole_beside_the_arc()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Square(0, 0, 10).Line(5, 30, 5, 15));
        await talk.TypeAsync("FILLET", "R", "2", "2,10", "5,20");

        Assert.Equal(["LwPolyline closed: 0,0>10,0 | 10,0>10,10 | 10,10>0,10 | 0,10>0,0", "Line: 5,30>5,12", "Arc: 3,12 r2 270+90"], ObjectText.All(talk));
    }

    /// <summary>The circle stays; the arc that leads to it becomes part of the polyline. Centre 25,y: 5 above the line y = 0, and 15 from the circle's
    /// centre 25,20.</summary>
    [Fact]
    public async Task The_arc_to_a_circle_belongs_to_the_polyline()
    {
        await using var talk = ObjectText.Talk(Polyline(new(0, -10), new(0, 0), new(20, 0)).Circle(25, 20, 10));
        await talk.TypeAsync("FILLET", "R", "5", "10,0", "24,10");

        Assert.Equal(["LwPolyline: 0,-10>0,0 | 0,0>25,0 | 25,5 r5 270+180", "Circle closed: 25,20 r10 0+360"], ObjectText.All(talk));
    }

    [Fact]
    public async Task A_chamfer_joins_a_line_and_a_polyline()
    {
        await using var talk = ObjectText.Talk(Polyline(s_zigzag).Line(40, 30, 24, 30));
        await talk.TypeAsync("CHAMFER", "D", "3", "5", "20,10", "30,30");

        Assert.Equal(["LwPolyline: 0,0>20,0 | 20,0>20,27 | 20,27>25,30 | 25,30>40,30"], ObjectText.All(talk));
    }

    [Fact]
    public async Task Without_trim_both_stay_and_the_arc_stands_alone()
    {
        await using var talk = ObjectText.Talk(Polyline(s_zigzag).Line(40, 30, 24, 30));
        await talk.TypeAsync("FILLET", "T", "N", "R", "4", "20,10", "30,30");

        Assert.Equal(["LwPolyline: 0,0>20,0 | 20,0>20,20 | 20,20>0,20", "Line: 40,30>24,30", "Arc: 24,26 r4 180-90"], ObjectText.All(talk));
    }

    [Fact]
    public async Task Parts_that_are_farther_apart_are_not_joined()
    {
        await using var talk = ObjectText.Talk(Polyline(new(0, 0), new(10, 0), new(10, 5), new(15, 5), new(15, 20), new(40, 20)));
        await talk.TypeAsync("FILLET", "R", "1", "5,0", "15,10");

        Assert.Contains("two lines with one segment between them", talk.Said, StringComparison.Ordinal);
        await talk.Session.CancelAsync();
    }

    private static DrawingBuilder Polyline(params Point2D[] places) => new DrawingBuilder().Curve(CurveType.LwPolyline, [.. places.Zip(places.Skip(1), Segment.FromLine)]);
}
