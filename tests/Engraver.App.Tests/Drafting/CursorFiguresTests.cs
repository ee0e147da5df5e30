using Avalonia;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Documents;

namespace Engraver.App.Tests.Drafting;

/// <summary>Precision and reach at the cursor in the whole window: a line from 0,0 to 100,0.</summary>
[Collection(DesktopCollection.Name)]
public sealed class CursorFiguresTests(DesktopFixture fixture)
{
    [Fact]
    public Task The_coordinates_at_the_cursor_follow_LUPREC_and_AUPREC() => With(here =>
    {
        here.Enter("LUPREC", "1", "AUPREC", "0");
        here.Hands.MovePointer(At(here, 40, 20));
        here.Step();
        Assert.Matches(@"^-?\d+\.\d, -?\d+\.\d$", here.Window.Model.Status.Coordinates);
        here.Enter("LUPREC", "0");
        Assert.Matches(@"^-?\d+, -?\d+$", here.Window.Model.Status.Coordinates); // although the mouse is at rest

        here.Enter("LUPREC", "3", "LINE", "0,0");
        here.Hands.MovePointer(At(here, 40, 30));
        here.Step();
        Assert.Matches(@"\n\d+\.\d{3} < \d+°$", here.Window.Canvas.Pointing.Tip);
        here.Enter("");
    });

    [Fact]
    public Task A_pick_of_a_command_reaches_as_far_as_the_pickbox_that_is_shown() => With(here =>
    {
        var (near, canvas) = (At(here, 50, 0) + new Vector(0.0, 8.0), here.Window.Canvas);
        here.Enter("ERASE");
        here.Hands.Click(near);
        here.WaitUntilIdle();
        Assert.StartsWith("Specify opposite corner", here.Commands.Prompt.Text, StringComparison.Ordinal); // a box starts: 8 is more than 5
        here.Commands.CancelAsync().Wait(TimeSpan.FromSeconds(60));
        here.WaitUntilIdle();

        here.Enter("PICKBOX", "10", "ERASE");
        here.Hands.Click(near);
        here.WaitUntilIdle();
        Assert.Equal([0], canvas.Selection);
        here.Enter("");
        Assert.Equal(0, here.Commands.Document.Current.Drawing!.Entities.Count);
    });

    private Task With(Action<Operator> test) => fixture.WithOperator(here =>
    {
        here.Commands.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 100, 0).Build() });
        here.WaitUntilIdle();
        here.Enter("ZOOM", "C", "50,0", "300");
        test(here);
    });

    private static Point At(Operator here, double x, double y)
    {
        var pixel = here.Window.Canvas.PixelView.ToPixels(new Point2D(x, y));
        return here.Window.Canvas.TranslatePoint(new Point(pixel.X, pixel.Y), here.Window)!.Value;
    }
}
