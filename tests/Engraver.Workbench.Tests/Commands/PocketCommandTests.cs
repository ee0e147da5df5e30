using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

public class PocketCommandTests
{
    /// <summary>A circle of radius 3 and a tool of 2, half a diameter from pass to pass: passes of radius 2, 1 and a last one that is a point.</summary>
    [Fact]
    public async Task A_circle_is_cleared_on_a_layer_of_its_own_and_undone()
    {
        await using var talk = CommandTalk.WithDrawing();
        var before = talk.State.Drawing!;
        await talk.TypeAsync("POCKET", "H", "A3", "", "2", "0.5", "Contour", "0");
        var drawing = talk.State.Drawing!;
        var added = talk.State.Previous.Single();

        Assert.Equal("POCKET", drawing.Layers[drawing.Entities[added].Layer].Name);
        Assert.Equal(CurveType.LwPolyline, drawing.Entities[added].Type);
        Assert.Contains("100 % of 28.274 mm2 covered", talk.Said, StringComparison.Ordinal);
        Assert.Contains("half a tool diameter into the wall", talk.Said, StringComparison.Ordinal); // the circle itself is still cut
        Assert.All(Outline(drawing, added), segment => Assert.True(segment.PointAt(0.5).DistanceTo(new Point2D(20, 5)) <= 2.0 + 1e-9));
        await talk.TypeAsync("U");
        Assert.Same(before, talk.State.Drawing);
    }

    [Fact]
    public async Task Values_are_remembered_and_levels_lie_at_their_depths()
    {
        await using var talk = CommandTalk.WithDrawing();
        await talk.TypeAsync("POCKET", "H", "A4", "", "1", "0.7", "Zigzag", "30", "2", "1");
        Assert.Equal([-1.0, -2.0], talk.State.Previous.Select(index => talk.State.Drawing!.Parts[talk.State.Drawing.Entities[index].FirstPart].C));
        await talk.TypeAsync("U", "POCKET", "H", "A4", "", "", "", "", "", "", "");
        Assert.Equal([-1.0, -2.0], talk.State.Previous.Select(index => talk.State.Drawing!.Parts[talk.State.Drawing.Entities[index].FirstPart].C));
        Assert.Contains("POC0002", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task What_the_tool_does_not_fit_into_is_said_and_changes_nothing()
    {
        await using var talk = CommandTalk.WithDrawing();
        var before = talk.State.Drawing;

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("POCKET", "H", "A3", "", "7", "0.5", "Contour", "0"));
        Assert.Contains("POC0001", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("POCKET", "H", "A1", "", "1", "0.5", "Contour", "0"));
        Assert.Contains("POC0005", talk.Said, StringComparison.Ordinal);
        Assert.Same(before, talk.State.Drawing);
    }

    private static List<Segment> Outline(Drawing drawing, int index)
    {
        var entity = drawing.Entities[index];
        return [.. Enumerable.Range(entity.FirstPart, entity.PartCount).Select(part => drawing.SegmentOf(drawing.Parts[part]))];
    }
}
