using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Workbench.Tests.Commands.Reshaping;

/// <summary>TRIM and EXTEND: a line along y = 0 (A1), two posts at x = 3 (A2) and x = 7 (A3), a short line (A4) and a circle (A5) beside them.</summary>
public class TrimCommandTests
{
    private static DrawingBuilder Yard() => new DrawingBuilder().Line(0, 0, 10, 0).Line(3, -4, 3, 4).Line(7, -4, 7, 4).Line(0, 2, 2, 2).Circle(20, 0, 5);

    [Fact]
    public async Task Enter_means_that_all_objects_cut()
    {
        await using var talk = ObjectText.Talk(Yard());
        await talk.TypeAsync("TR", "", "5,0", "");

        Assert.Equal(["Line: 0,0>3,0", "Line: 7,0>10,0", "Line: 3,-4>3,4"], ObjectText.All(talk)[..3]);
        Assert.Equal("A1", talk.State.Drawing!.SourceOf(0).Handle);
        Assert.NotEqual("A1", talk.State.Drawing.SourceOf(1).Handle);
    }

    [Fact]
    public async Task Only_the_edges_that_were_selected_cut()
    {
        await using var talk = ObjectText.Talk(Yard());
        await talk.TypeAsync("TRIM", "3,3", "", "5,0", "");

        Assert.Equal("Line: 0,0>3,0", ObjectText.All(talk)[0]);
        Assert.Equal(5, talk.State.Drawing!.Entities.Count);
    }

    [Fact]
    public async Task All_trims_of_a_command_are_one_step_and_its_Undo_takes_back_one()
    {
        await using var talk = ObjectText.Talk(Yard());
        var steps = talk.Session.Document.UndoNames.Count();
        await talk.TypeAsync("TRIM", "", "1,0", "9,0");
        Assert.Equal("Line: 3,0>7,0", ObjectText.All(talk)[0]);
        await talk.TypeAsync("U");
        Assert.Equal("Line: 3,0>10,0", ObjectText.All(talk)[0]);
        await talk.TypeAsync("");

        Assert.Equal(steps + 1, talk.Session.Document.UndoNames.Count());
        await talk.TypeAsync("U");
        Assert.Equal("Line: 0,0>10,0", ObjectText.All(talk)[0]);
        await talk.TypeAsync("REDO");
        Assert.Equal("Line: 3,0>10,0", ObjectText.All(talk)[0]);
    }

    [Fact]
    public async Task Undoing_all_within_the_command_leaves_no_step()
    {
        await using var talk = ObjectText.Talk(Yard());
        var steps = talk.Session.Document.UndoNames.Count();
        await talk.TypeAsync("TRIM", "", "1,0", "9,0", "U", "U", "U", "");

        Assert.Equal(steps, talk.Session.Document.UndoNames.Count());
        Assert.Equal("Line: 0,0>10,0", ObjectText.All(talk)[0]);
        Assert.Contains("Nothing to undo", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Shift_extends_within_TRIM_and_trims_within_EXTEND()
    {
        await using var talk = ObjectText.Talk(Yard());
        await talk.TypeAsync("TRIM", "", "shift:2,2", "", "EX", "", "shift:5,0", "");

        Assert.Contains("Line: 0,2>3,2", ObjectText.All(talk));
        Assert.Equal(["Line: 0,0>3,0", "Line: 7,0>10,0"], ObjectText.All(talk)[..2]);
    }

    [Fact]
    public async Task Extend_goes_on_from_edge_to_edge()
    {
        await using var talk = ObjectText.Talk(Yard());
        await talk.TypeAsync("EXTEND", "", "2,2", "3,2.01");
        await talk.TypeAsync("2.9,2", "", "EXTEND", "", "0,2", "");

        Assert.Equal("Line: 0,2>7,2", ObjectText.All(talk)[3]);
        Assert.Contains("does not reach any boundary edge", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_circle_becomes_an_arc_and_a_fence_trims_all_that_it_crosses()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Circle(0, 0, 5).Line(3, -9, 3, 9).Line(-9, 8, 9, 8).Line(-9, 7, 9, 7).Line(-9, 6, 9, 6));
        await talk.TypeAsync("TRIM", "3,-8", "", "F", "6,5.5", "6,8.5", "", "5,0", "");

        Assert.Equal("Arc: 0,0 r5 53.130102+253.739795", ObjectText.All(talk)[0]);
        Assert.Equal(["Line: -9,8>3,8", "Line: -9,7>3,7", "Line: -9,6>3,6"], ObjectText.All(talk)[2..]);
    }

    [Fact]
    public async Task A_crossing_box_trims_what_it_touches_and_a_click_on_empty_ground_begins_one()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(3, -9, 3, 9).Line(-9, 8, 9, 8).Line(-9, 7, 9, 7));
        await talk.TypeAsync("TRIM", "3,-8", "", "C", "8,8.5", "6,7.5", "7,6", "6,7.2", "");

        Assert.Equal(["Line: -9,8>3,8", "Line: -9,7>3,7"], ObjectText.All(talk)[1..]);
    }

    [Fact]
    public async Task Polylines_with_bulges_and_ellipses_are_cut_too()
    {
        var arc = Segment.FromArc(ArcSegment.FromBulge(new Point2D(10, 0), new Point2D(10, 10), 1.0));
        await using var talk = ObjectText.Talk(new DrawingBuilder()
            .Curve(Engraver.Core.Drawings.CurveType.LwPolyline, Segment.FromLine(new Point2D(0, 0), new Point2D(10, 0)), arc, Segment.FromLine(new Point2D(10, 10), new Point2D(0, 10)))
            .Line(11, 5, 30, 5).Free(FreeCurves.Ellipse(50, 0, 10, 0.5, 0, 0, 360).ToCurve()).Line(50, -20, 50, 20));
        await talk.TypeAsync("TRIM", "", "5,10", "60,0", "");

        Assert.Equal("LwPolyline: 0,0>10,0 | 10,5 r5 270+90", ObjectText.All(talk)[0]);
        Assert.Equal("Ellipse: curve 50,5>50,-5", ObjectText.All(talk)[2]);
    }

    [Fact]
    public async Task Edges_cut_beyond_their_ends_when_asked_for_and_that_is_remembered()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0).Line(4, 1, 4, 5));
        await talk.TypeAsync("TRIM", "", "8,0");
        Assert.Contains("No edge crosses", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("E", "E", "8,0", "");
        Assert.Equal("Line: 0,0>4,0", ObjectText.All(talk)[0]);
        await talk.TypeAsync("U", "TRIM", "", "1,0", "");
        Assert.Equal("Line: 4,0>10,0", ObjectText.All(talk)[0]);
    }

    [Fact]
    public async Task Erase_within_TRIM_keeps_the_edges()
    {
        await using var talk = ObjectText.Talk(Yard());
        await talk.TypeAsync("TRIM", "7,3", "", "R", "3,3", "", "1,0", "");

        Assert.Equal("Line: 7,0>10,0", ObjectText.All(talk)[0]);
        Assert.Equal("Line: 7,-4>7,4", ObjectText.All(talk)[1]);
    }

    [Fact]
    public async Task What_goes_is_seen_before()
    {
        await using var talk = ObjectText.Talk(Yard());
        await talk.TypeAsync("TRIM", "");
        var ghost = talk.Session.Prompt.PointRequest!.Ghost!(new Point2D(5, 0));

        Assert.Equal([Segment.FromLine(new Point2D(3, 0), new Point2D(7, 0))], ghost);
        await talk.Session.CancelAsync();
    }

    /// <summary>Esc ends the command; earlier trims are kept, as in AutoCAD, and are one undo step.</summary>
    [Fact]
    public async Task Esc_keeps_what_was_trimmed()
    {
        await using var talk = ObjectText.Talk(Yard());
        await talk.TypeAsync("TRIM", "", "1,0", "9,0");
        await talk.Session.CancelAsync();
        Assert.Equal("Line: 3,0>7,0", ObjectText.All(talk)[0]);
        await talk.TypeAsync("U");

        Assert.Equal("Line: 0,0>10,0", ObjectText.All(talk)[0]);
    }
}
