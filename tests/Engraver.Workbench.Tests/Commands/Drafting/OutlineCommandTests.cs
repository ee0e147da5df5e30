using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Drafting;

/// <summary>RECTANG, POLYGON and ELLIPSE.</summary>
public class OutlineCommandTests
{
    [Theory]
    [InlineData("1,2", "5,4", "(1,2 5,2) (5,2 5,4) (5,4 1,4) (1,4 1,2)")]
    [InlineData("0,0", "D", "6", "3", "-1,1", "(0,0 -6,0) (-6,0 -6,3) (-6,3 0,3) (0,3 0,0)")]
    [InlineData("0,0", "A", "18", "L", "6", "1,-1", "(0,0 6,0) (6,0 6,-3) (6,-3 0,-3) (0,-3 0,0)")]
    [InlineData("0,0", "A", "18", "W", "6", "1,1", "(0,0 3,0) (3,0 3,6) (3,6 0,6) (0,6 0,0)")]
    [InlineData("0,0", "R", "90", "-2,5", "(0,0 0,5) (0,5 -2,5) (-2,5 -2,0) (-2,0 0,0)")]
    [InlineData("0,0", "R", "P", "7,7", "7,9", "-2,5", "(0,0 0,5) (0,5 -2,5) (-2,5 -2,0) (-2,0 0,0)")]
    [InlineData("F", "1", "0,0", "4,2", "(1,0 3,0) (3,1 r1 from 270 by 90) (3,1 r1 from 0 by 90) (3,2 1,2) (1,1 r1 from 90 by 90) (1,1 r1 from 180 by 90)")]
    [InlineData("C", "1", "0.5", "0,0", "4,2", "(0.5,0 3,0) (3,0 4,0.5) (4,0.5 4,1) (4,1 3.5,2) (3.5,2 1,2) (1,2 0,1.5) (0,1.5 0,1) (0,1 0.5,0)")]
    public async Task Rectangles(params string[] inputsAndOutline)
    {
        await using var talk = new CommandTestSession();
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(["REC", .. inputsAndOutline[..^1]]));

        Assert.Equal([$"LwPolyline closed {inputsAndOutline[^1]}"], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task Corners_and_turn_of_a_rectangle_are_kept_for_the_next_and_told()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("RECTANG", "F", "1", "0,0", "4,4", "RECTANG");
        Assert.Contains("Fillet=1", talk.Said, StringComparison.Ordinal);
        Assert.Equal("Specify first corner point or [Chamfer/Fillet]:", talk.Session.Prompt.Text);
        await talk.TypeAsync("F", "0", "10,0", "12,1");

        Assert.Equal("LwPolyline closed (10,0 12,0) (12,0 12,1) (12,1 10,1) (10,1 10,0)", CurveText.Of(talk.State.Drawing)[^1]);
    }

    [Fact]
    public async Task A_polygon_smaller_than_the_digits_of_its_place_is_asked_for_again()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("POLYGON", "4", "1e8,1e8", "I", "1e-9");

        Assert.Equal("POLYGON", talk.Session.Prompt.Command);
        Assert.Contains("cannot be drawn with this input", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_rectangle_without_width_is_asked_for_again_and_seen_beforehand()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("REC", "0,0", "5,0");
        Assert.Contains("cannot be drawn", talk.Said, StringComparison.Ordinal);

        Assert.Equal(4, talk.Session.Prompt.PointRequest!.Ghost!(new(3, 3)).Count);
        Assert.Empty(talk.Session.Prompt.PointRequest!.Ghost!(new(3, 0)));
    }

    [Theory]
    [InlineData("4", "0,0", "I", "1,1", "(1,1 -1,1) (-1,1 -1,-1) (-1,-1 1,-1) (1,-1 1,1)")]
    [InlineData("4", "0,0", "C", "1,0", "(1,1 -1,1) (-1,1 -1,-1) (-1,-1 1,-1) (1,-1 1,1)")]
    [InlineData("4", "0,0", "C", "1", "(1,-1 1,1) (1,1 -1,1) (-1,1 -1,-1) (-1,-1 1,-1)")]
    [InlineData("4", "E", "0,0", "2,0", "(0,0 2,0) (2,0 2,2) (2,2 0,2) (0,2 0,0)")]
    [InlineData("3", "0,0", "I", "2", "(1.732051,-1 0,2) (0,2 -1.732051,-1) (-1.732051,-1 1.732051,-1)")]
    public async Task Polygons(params string[] inputsAndOutline)
    {
        await using var talk = new CommandTestSession();
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(["POL", .. inputsAndOutline[..^1]]));

        Assert.Equal([$"LwPolyline closed {inputsAndOutline[^1]}"], CurveText.Of(talk.State.Drawing));
    }

    [Fact]
    public async Task Sides_of_the_last_polygon_are_the_default_and_two_are_too_few()
    {
        await using var talk = new CommandTestSession();
        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("POLYGON", "2"));
        await talk.TypeAsync("6", "0,0", "C", "5", "POLYGON");
        Assert.Equal("Enter number of sides <6>:", talk.Session.Prompt.Text);
        await talk.TypeAsync("", "0,0");

        Assert.Equal("Enter an option [Inscribed/Circumscribed] <Circumscribed>:", talk.Session.Prompt.Text);
    }

    [Theory]
    [InlineData("-10,0", "10,0", "5", "Ellipse (Ellipse -10,0 10,0 -10,0)")]
    [InlineData("C", "1,1", "11,1", "4", "Ellipse (Ellipse 11,1 -9,1 11,1)")]
    [InlineData("C", "0,0", "10,0", "R", "60", "Ellipse (Ellipse 10,0 -10,0 10,0)")]
    [InlineData("C", "0,0", "10,0", "10", "Circle (0,0 r10)")]
    [InlineData("A", "C", "0,0", "10,0", "5", "0", "180", "Ellipse (Ellipse 10,0 0,5 -10,0)")]
    [InlineData("A", "C", "0,0", "10,0", "5", "0,9", "0,-9", "Ellipse (Ellipse 0,5 -10,0 0,-5)")]
    [InlineData("A", "C", "0,0", "10,0", "5", "90", "I", "180", "Ellipse (Ellipse 0,5 -10,0 0,-5)")]
    [InlineData("A", "-10,0", "10,0", "5", "P", "180", "270", "Ellipse (Ellipse 10,0 7.071068,3.535534 0,5)")]
    [InlineData("A", "C", "0,0", "10,0", "10", "0", "90", "Arc (0,0 r10 from 0 by 90)")]
    public async Task Ellipses(params string[] inputsAndEllipse)
    {
        await using var talk = new CommandTestSession();
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(["EL", .. inputsAndEllipse[..^1]]));

        Assert.Equal([inputsAndEllipse[^1]], CurveText.Of(talk.State.Drawing));
    }

    /// <summary>By its parameter a point at 45 degrees of an ellipse of 10 by 5 is 7.07,3.54; seen at 45 degrees it is 4.47,4.47.</summary>
    [Fact]
    public async Task An_angle_is_where_a_point_is_seen_and_a_parameter_is_not()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("EL", "A", "C", "0,0", "10,0", "5", "45", "180", "EL", "A", "C", "0,0", "10,0", "5", "P", "45", "180");
        var starts = new[] { 0, 1 }.Select(index => DrawingPick.Segments(talk.State.Drawing!, index).Single().Start).ToArray();

        Assert.True(starts[0].IsNear(new Point2D(Math.Sqrt(20), Math.Sqrt(20)), 1e-9), starts[0].ToString());
        Assert.True(starts[1].IsNear(new Point2D(Math.Sqrt(50), Math.Sqrt(12.5)), 1e-9), starts[1].ToString());
    }

    [Fact]
    public async Task An_ellipse_with_no_other_axis_is_asked_for_again()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("EL", "-10,0", "10,0", "0.000001");
        Assert.Contains("cannot be drawn", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("5", "U");

        Assert.Empty(CurveText.Of(talk.State.Drawing));
    }
}
