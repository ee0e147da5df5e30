using Avalonia.Controls;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Views;

namespace Engraver.App.Tests.Findings;

[Collection(DesktopCollection.Name)]
public sealed class FindingsTests(DesktopFixture fixture)
{
    [Fact]
    public Task A_click_on_a_finding_goes_to_its_place() => fixture.WithOperator(here =>
    {
        here.Open("clock-dial.dxf");
        here.Show("Findings");
        var list = here.Find<ListBox>("FindingList");
        Assert.NotEqual(0, list.ItemCount);
        var before = here.Commands.View.Current.Height;
        here.Click(list.ContainerFromIndex(0)!);

        Assert.NotNull(here.Commands.View.Current.Focus);
        Assert.True(here.Commands.View.Current.Height < before);
    });

    /// <summary>The break is at the end of a line, 40 mm from the start of its entity.</summary>
    [Fact]
    public Task The_marker_of_a_break_stands_at_the_break_and_the_list_goes_there() => fixture.WithOperator(here =>
    {
        var folder = Directory.CreateTempSubdirectory("engraver-break-");
        var file = Path.Combine(folder.FullName, "break.dxf");
        File.WriteAllBytes(file, DxfText.WithEntities((0, "LINE"), (8, "0"), (5, "A1"), (10, 0.0), (20, 0.0), (11, 40.0), (21, 0.0), (0, "LINE"), (8, "0"), (5, "A2"), (10, 40.3), (20, 0.0), (11, 40.3), (21, 30.0)).ToAscii());
        here.Enter("OPEN", file);
        here.WaitUntilIdle();
        here.Show("Findings");
        var rows = (Engraver.App.Findings.FindingsModel)here.Find<ListBox>("FindingList").DataContext!;
        var gap = rows.Rows.First(row => row.Id == "SEQ0003");
        rows.Chosen = gap;
        here.WaitUntilIdle();

        var focus = here.Commands.View.Current.Focus!.Place;
        Assert.InRange(focus.X, 40.0, 40.3);
        Assert.Equal(0.0, focus.Y, 6);
        Assert.NotNull(here.Window.Canvas.Overlay!.FindingNear(focus, 1e-6));
        here.Enter("CIRCLE", "90,90", "2");
        here.WaitUntilIdle();
        Assert.NotNull(here.Commands.View.Current.Focus); // the gap is still there
        here.Enter("MOVE", "H", "A2", "", "0,0", "0.1,0");
        here.WaitUntilIdle();
        Assert.NotNull(here.Commands.View.Current.Focus); // and wider, which changes its sentence
        here.Commands.View.FocusOn(new ViewFocus(new Point2D(1, 2), null), null);
        here.Enter("CIRCLE", "90,90", "4");
        here.WaitUntilIdle();
        Assert.NotNull(here.Commands.View.Current.Focus); // a point clicked on the canvas
        rows.Chosen = null;
        rows.Chosen = rows.Rows.First(row => row.Id == "SEQ0003");
        here.Enter("LINE", "40,0", "40.4,0", "");
        here.WaitUntilIdle();
        Assert.Null(here.Commands.View.Current.Focus);
        folder.Delete(recursive: true);
    });
}
