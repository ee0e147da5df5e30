using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>GRIPEDIT on a line (A1, from 0,0 to 10,0), an arc (A2, 5,5, radius 4, 350 to 100 degrees), a circle (A3, 20,5, radius 3) and a square (A4,
/// 30,0, side 8).</summary>
public class GripEditTests
{
    [Fact]
    public async Task The_end_of_a_line_is_stretched_and_its_middle_moves_it()
    {
        await using var talk = await SelectedAsync("A1");
        await talk.TypeAsync("GRIPEDIT", "10,0", "12,3");
        Assert.Equal((new Point2D(0, 0), new Point2D(12, 3)), Ends(talk, 0));

        await talk.TypeAsync("GRIPEDIT", "6,1.5", "@0,1");
        Assert.Equal((new Point2D(0, 1), new Point2D(12, 4)), Ends(talk, 0));
        Assert.Equal([0], talk.State.Selection);
    }

    /// <summary>Compared with the circle through three points: its centre has the same distance from all of them.</summary>
    [Fact]
    public async Task An_arc_is_bent_by_its_middle_and_keeps_its_ends()
    {
        await using var talk = await SelectedAsync("A2");
        var (start, end) = Ends(talk, 1);
        var middle = Only(talk, 1).PointAt(0.5);
        await talk.TypeAsync("GRIPEDIT", Typed(middle), "11,11");
        var bent = Only(talk, 1);

        Assert.True(bent.Start.IsNear(start, 1e-9) && bent.End.IsNear(end, 1e-9));
        Assert.Equal(0.0, bent.DistanceTo(new Point2D(11, 11)), 1e-9);
        Assert.All([start, end, new Point2D(11, 11)], place => Assert.Equal(bent.Arc.Radius, bent.Arc.Centre.DistanceTo(place), 1e-9));
        Assert.True(bent.Arc.Sweep.Degrees > 110.0); // farther out than before: more than before

        await talk.TypeAsync("U", "GRIPEDIT", Typed(middle), "4,3");
        Assert.True(Only(talk, 1).Arc.Sweep.Degrees < 0.0); // on the other side of the chord the arc turns the other way
        Assert.Equal(0.0, Only(talk, 1).DistanceTo(new Point2D(4, 3)), 1e-9);
    }

    [Fact]
    public async Task The_end_of_an_arc_keeps_the_included_angle_and_its_centre_moves_it()
    {
        await using var talk = await SelectedAsync("A2");
        var (start, end) = Ends(talk, 1);
        await talk.TypeAsync("GRIPEDIT", Typed(end), "0,12");
        var stretched = Only(talk, 1).Arc;
        Assert.Equal(110.0, stretched.Sweep.Degrees, 1e-9);
        Assert.True(stretched.StartPoint.IsNear(start, 1e-9) && stretched.EndPoint.IsNear(new Point2D(0, 12), 1e-9));

        await talk.TypeAsync("U", "GRIPEDIT", "5,5", "@1,2");
        Assert.Equal((new Point2D(6, 7), 4.0), (Only(talk, 1).Arc.Centre, Only(talk, 1).Arc.Radius));
    }

    [Fact]
    public async Task A_circle_takes_the_radius_that_is_pointed_at()
    {
        await using var talk = await SelectedAsync("A3");
        await talk.TypeAsync("GRIPEDIT", "23,5", "20,10");
        Assert.Equal((new Point2D(20, 5), 5.0), (Only(talk, 2).Arc.Centre, Only(talk, 2).Arc.Radius));
        Assert.Equal(CurveType.Circle, talk.State.Drawing!.Entities[2].Type);
    }

    [Fact]
    public async Task A_vertex_of_a_polyline_takes_both_its_sides_along_and_a_side_both_its_vertices()
    {
        await using var talk = await SelectedAsync("A4");
        await talk.TypeAsync("GRIPEDIT", "30,0", "29,-1");
        Point2D[] corners = [.. DrawingPick.Segments(talk.State.Drawing!, 3).Select(side => side.Start)];
        Assert.Equal([new(29, -1), new(38, 0), new(38, 8), new(30, 8)], corners);
        Assert.Equal(new Point2D(29, -1), DrawingPick.Segments(talk.State.Drawing!, 3).Last().End);

        await talk.TypeAsync("GRIPEDIT", "38,4", "40,4");
        Assert.Equal([new(29, -1), new(40, 0), new(40, 8), new(30, 8)], DrawingPick.Segments(talk.State.Drawing!, 3).Select(side => side.Start));
    }

    /// <summary>Two lines that meet: the grips coincide and move together.</summary>
    [Fact]
    public async Task Grips_in_one_place_are_dragged_together()
    {
        await using var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 10, 0).Line(10, 0, 10, 5).Build() });
        talk.Session.Document.Select([0, 1], []);
        await talk.TypeAsync("GRIPEDIT", "10,0", "8,-2");

        Assert.Equal(new Point2D(8, -2), Ends(talk, 0).End);
        Assert.Equal((new Point2D(8, -2), new Point2D(10, 5)), Ends(talk, 1));
        await talk.TypeAsync("U");
        Assert.Equal((new Point2D(10, 0), new Point2D(10, 5)), Ends(talk, 1)); // one step for both
    }

    [Fact]
    public async Task Enter_goes_from_stretch_to_move_rotate_scale_and_mirror()
    {
        await using var talk = await SelectedAsync("A1");
        await talk.TypeAsync("GRIPEDIT", "10,0", "", "0,0");
        Assert.Equal((new Point2D(-10, 0), new Point2D(0, 0)), Ends(talk, 0));
        await talk.TypeAsync("U", "GRIPEDIT", "10,0", "", "", "90");
        Assert.Equal((new Point2D(10, -10), new Point2D(10, 0)), Ends(talk, 0));
        await talk.TypeAsync("U", "GRIPEDIT", "10,0", "", "", "", "2");
        Assert.Equal((new Point2D(-10, 0), new Point2D(10, 0)), Ends(talk, 0));
        await talk.TypeAsync("U", "GRIPEDIT", "10,0", "", "", "", "", "10,5");
        Assert.Equal((new Point2D(20, 0), new Point2D(10, 0)), Ends(talk, 0));
        Assert.Contains("** MIRROR **", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task With_Copy_the_objects_stay_and_all_copies_are_one_step()
    {
        await using var talk = await SelectedAsync("A1");
        await talk.TypeAsync("GRIPEDIT", "10,0", "C", "10,3", "10,6", "10,9", "U", "");
        Assert.Equal(6, talk.State.Drawing!.Entities.Count);
        Assert.Equal((new Point2D(0, 0), new Point2D(10, 0)), Ends(talk, 0));
        Assert.Equal([new Point2D(10, 3), new Point2D(10, 6)], new[] { Ends(talk, 4).End, Ends(talk, 5).End });
        await talk.TypeAsync("U");
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
    }

    [Fact]
    public async Task Where_nothing_would_be_left_it_is_told_and_nothing_changes()
    {
        await using var talk = await SelectedAsync("A1");
        await talk.TypeAsync("GRIPEDIT", "10,0", "0,0");
        Assert.Contains("would vanish or be out of range", talk.Said, StringComparison.Ordinal);
        Assert.Equal((new Point2D(0, 0), new Point2D(10, 0)), Ends(talk, 0));
        Assert.Equal("GRIPEDIT", talk.Session.Prompt.Command);
        await talk.TypeAsync("X");

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("GRIPEDIT", "3,3"));
        await talk.Session.CancelAsync();
        Assert.Contains("Select 1 to", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("GRIPEDIT")).Message, StringComparison.Ordinal);
    }

    /// <summary>Esc, a base point elsewhere, and the ghost that shows what a click would give.</summary>
    [Fact]
    public async Task The_ghost_is_what_the_click_gives_and_Esc_leaves_all_as_it_was()
    {
        await using var talk = await SelectedAsync("A1");
        await talk.TypeAsync("GRIPEDIT", "10,0");
        Assert.Equal([Segment.FromLine(new Point2D(0, 0), new Point2D(7, 7))], talk.Session.Prompt.PointRequest!.Ghost!(new Point2D(7, 7)));
        Assert.Equal([], talk.Session.Prompt.PointRequest!.Ghost!(new Point2D(0, 0)));
        await talk.Session.CancelAsync();
        Assert.Equal((new Point2D(0, 0), new Point2D(10, 0)), Ends(talk, 0));

        talk.Session.Document.Select([0], []);
        await talk.TypeAsync("GRIPEDIT", "10,0", "B", "100,100", "101,102");
        Assert.Equal(new Point2D(11, 2), Ends(talk, 0).End);
    }

    /// <summary>The half axes of an ellipse of 10 and 5, and an open spline.</summary>
    [Fact]
    public async Task An_ellipse_takes_another_axis_and_a_spline_another_end()
    {
        await using var talk = new CommandTestSession();
        var ellipse = new EllipseArc(default, new Vector3D(10, 0, 0), new Vector3D(0, 5, 0), Angle.Zero, Angle.FullTurn).ToCurve();
        var spline = new RationalCurve(SegmentKind.Spline, [new BezierSpan([0, 20, 0, 1, 1, 22, 0, 1, 3, 22, 0, 1, 4, 20, 0, 1])]);
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Free(ellipse).Free(spline).Build() });
        talk.Session.Document.Select([0, 1], []);
        await talk.TypeAsync("GRIPEDIT", "0,5", "0,8", "GRIPEDIT", "4,20", "6,21");

        var (box, bent) = (Only(talk, 0).Bounds, Only(talk, 1));
        Assert.Equal([-10.0, 10.0, -8.0, 8.0], new[] { box.MinX, box.MaxX, box.MinY, box.MaxY }.Select(side => Math.Round(side, 9)));
        Assert.Equal((new Point2D(0, 20), new Point2D(6, 21)), (bent.Start, bent.End));
    }

    private static async Task<CommandTestSession> SelectedAsync(string handle)
    {
        var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SELECT", "H", handle, "");
        return talk;
    }

    private static Segment Only(CommandTestSession talk, int entity) => DrawingPick.Segments(talk.State.Drawing!, entity).Single();

    private static (Point2D Start, Point2D End) Ends(CommandTestSession talk, int entity) => (Only(talk, entity).Start, Only(talk, entity).End);

    private static string Typed(Point2D place) => FormattableString.Invariant($"{place.X:R},{place.Y:R}");
}
