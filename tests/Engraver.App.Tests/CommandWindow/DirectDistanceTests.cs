using Avalonia;
using Engraver.App.Desk;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.App.Tests.CommandWindow;

[Collection(DesktopCollection.Name)]
public sealed class DirectDistanceTests(DesktopFixture fixture)
{
    [Theory]
    [InlineData("5", "4,5")]
    [InlineData("-10", "-5,-7")]
    [InlineData("@5,0", "@5,0")]
    [InlineData("U", "U")]
    [InlineData("", "")]
    public void A_number_goes_towards_the_cursor_and_nothing_else_does(string typed, string entered) =>
        Assert.Equal(entered, DirectDistance.Read(typed, new Point2D(1, 1), new Point2D(31, 41)));

    [Fact]
    public void Without_a_place_before_it_or_a_cursor_a_number_stays_one()
    {
        Assert.Equal("5", DirectDistance.Read("5", null, new Point2D(31, 41)));
        Assert.Equal("5", DirectDistance.Read("5", new Point2D(1, 1), null));
        Assert.Equal("5", DirectDistance.Read("5", new Point2D(1, 1), new Point2D(1, 1)));
    }

    /// <summary>In an empty desktop: LINE creates a drawing; with ORTHO the cursor right of and above the last point means right, then up. The radius of
    /// CIRCLE stays the number that was typed.</summary>
    [Fact]
    public Task A_line_is_drawn_by_pointing_and_typing_lengths() => fixture.WithOperator(here =>
    {
        here.Enter("ORTHO", "ON", "LINE", "100,100");
        Point(here, 300, 110);
        here.Enter("25");
        Point(here, 130, 250);
        here.Enter("40", "", "CIRCLE", "200,100");
        Point(here, 300, 100);
        here.Enter("3");
        var drawing = here.Commands.Document.Current.Drawing!;
        var ends = Enumerable.Range(0, drawing.Entities.Count).SelectMany(index => DrawingPick.Segments(drawing, index)).ToArray();

        Assert.Equal([new Point2D(125, 100), new Point2D(125, 140)], ends[..2].Select(line => line.End));
        Assert.Equal(3.0, ends[2].Arc.Radius);
    });

    /// <summary>Moves the mouse to a point of the drawing.</summary>
    private static void Point(Operator here, double x, double y)
    {
        var canvas = here.Window.Canvas;
        var view = here.Commands.View.Current;
        var scale = canvas.Bounds.Height / view.Height;
        var at = new Point((canvas.Bounds.Width / 2.0) + ((x - view.Centre.X) * scale), (canvas.Bounds.Height / 2.0) - ((y - view.Centre.Y) * scale));
        here.Hands.MovePointer(canvas.TranslatePoint(at, here.Window)!.Value);
        here.WaitUntilIdle();
    }
}
