using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>OFFSET on a line (A1, from 0,0 to 10,0), an arc (A2), a circle (A3, 20,5, radius 3) and a square (A4, 30,0, side 8).</summary>
public class OffsetCommandTests
{
    [Fact]
    public async Task A_line_goes_to_the_side_that_is_pointed_at()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("OFFSET", "2", "5,0", "3,7", "5,0", "3,-7", "");
        var drawing = talk.State.Drawing!;

        Assert.Equal(6, drawing.Entities.Count);
        Assert.Equal(("0,2", "10,2"), Ends(drawing, 4));
        Assert.Equal(("0,-2", "10,-2"), Ends(drawing, 5));
        Assert.Equal(CurveType.Line, drawing.Entities[4].Type);
    }

    [Fact]
    public async Task A_circle_and_a_square_go_out_and_in()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("O", "1", "20,8", "20,5", "20,8", "20,20", "34,0", "34,-5", "34,0", "34,4", "");
        var drawing = talk.State.Drawing!;

        Assert.Equal([2.0, 4.0], new[] { 4, 5 }.Select(index => drawing.Parts[drawing.Entities[index].FirstPart].D));
        Assert.Equal([(CurveType.LwPolyline, true, 8), (CurveType.LwPolyline, true, 4)], new[] { 6, 7 }.Select(index => (drawing.Entities[index].Type, drawing.Entities[index].Closed, drawing.Entities[index].PartCount)));
    }

    [Fact]
    public async Task Through_a_point()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("OFFSET", "T", "5,0", "3,1.25", "");

        Assert.Equal(("0,1.25", "10,1.25"), Ends(talk.State.Drawing!, 4));
    }

    [Fact]
    public async Task The_distance_is_shown_by_two_points_and_kept()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("OFFSET", "0,0", "3,4", "5,0", "5,9", "", "OFFSET", "", "5,0", "5,-9", "");

        Assert.Equal([("0,5", "10,5"), ("0,-5", "10,-5")], new[] { Ends(talk.State.Drawing!, 4), Ends(talk.State.Drawing!, 5) });
    }

    [Fact]
    public async Task The_source_is_erased_and_another_layer_taken_when_asked_for()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var layer = talk.State.Drawing!.Layers[^1].Name;
        await talk.TypeAsync("OFFSET", "E", "Y", "L", layer, "2", "5,0", "3,7", "");
        var drawing = talk.State.Drawing!;

        Assert.Equal((4, ("0,2", "10,2")), (drawing.Entities.Count, Ends(drawing, 3)));
        Assert.Equal(drawing.Layers.Count - 1, drawing.Entities[3].Layer);
        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("OFFSET", "L", "nowhere"));
        await talk.TypeAsync(layer.ToLowerInvariant(), "2", "5,0", "3,-7", "");
        Assert.Equal(talk.State.Drawing!.Layers.Count - 1, talk.State.Drawing.Entities[^1].Layer);
    }

    [Fact]
    public async Task Every_offset_undoes_inside_and_after_the_command()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("OFFSET", "2", "5,0", "3,7", "5,0", "3,-7", "U");
        Assert.Equal(5, talk.State.Drawing!.Entities.Count);
        await talk.TypeAsync("U", "U", "", "U");

        Assert.Contains("Nothing to undo", talk.Said, StringComparison.Ordinal);
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
    }

    /// <summary>Multiple continues from the last result, in either direction, until Enter; then it asks for another object.</summary>
    [Fact]
    public async Task Multiple_offsets_what_was_made_last()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("OFFSET", "1.5", "5,0", "Multiple", "5,9", "5,9", "5,9", "", "20,8", "20,20", "");
        var drawing = talk.State.Drawing!;

        Assert.Equal([("0,1.5", "10,1.5"), ("0,3", "10,3"), ("0,4.5", "10,4.5")], new[] { 4, 5, 6 }.Select(index => Ends(drawing, index)));
        Assert.Equal((8, 4.5), (drawing.Entities.Count, drawing.Parts[drawing.Entities[7].FirstPart].D));
    }

    [Fact]
    public async Task Undo_within_Multiple_goes_back_to_what_was_made_before()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("OFFSET", "E", "Y", "1", "5,0", "M", "5,9", "5,9", "U", "5,-9");
        Assert.Equal((4, ("0,0", "10,0")), (talk.State.Drawing!.Entities.Count, Ends(talk.State.Drawing!, 3))); // 0, 1, 2, back to 1, down to 0
        await talk.TypeAsync("Exit");
        Assert.Null(talk.Session.Prompt.Command);
    }

    [Fact]
    public async Task Through_and_Multiple_go_together()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("OFFSET", "T", "5,0", "M", "3,1.25", "3,4", "3,100", "");

        Assert.Equal([("0,1.25", "10,1.25"), ("0,4", "10,4"), ("0,100", "10,100")], new[] { 4, 5, 6 }.Select(index => Ends(talk.State.Drawing!, index)));
        await talk.Session.CancelAsync();
    }

    [Fact]
    public async Task What_is_left_of_nothing_and_a_place_on_nothing_are_told()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("OFFSET", "3", "20,8", "20,5", "100,100", "");

        Assert.Contains("nothing would remain", talk.Said, StringComparison.Ordinal);
        Assert.Contains("No object at this point", talk.Said, StringComparison.Ordinal);
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
    }

    /// <summary>The prompt previews the result of the click.</summary>
    [Fact]
    public async Task The_ghost_is_what_will_be_drawn()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("OFFSET", "2", "5,0");
        var ghost = talk.Session.Prompt.PointRequest!.Ghost!;

        Assert.Equal([Segment.FromLine(new Point2D(0, 2), new Point2D(10, 2))], ghost(new Point2D(3, 7)));
        Assert.Equal(-2.0, Assert.Single(ghost(new Point2D(3, -7))).Start.Y);
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
    }

    private static (string Start, string End) Ends(Drawing drawing, int entity)
    {
        var segment = drawing.SegmentOf(drawing.Parts[drawing.Entities[entity].FirstPart]);
        var (a, b) = (PointPrompt.Format(segment.Start), PointPrompt.Format(segment.End));
        return segment.Start.X <= segment.End.X ? (a, b) : (b, a);
    }
}
