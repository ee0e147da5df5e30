using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

public class ObjectCommandTests
{
    [Fact]
    public async Task Area_of_points_of_a_circle_of_a_square_and_of_an_open_arc()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("AREA", "0,0", "4,0", "4,3", "", "AREA", "O", "H", "A3", "H", "A4", "", "AREA", "", "H", "A2", "");
        var lines = talk.Said.Split('\n').Where(line => line.StartsWith("Area", StringComparison.Ordinal)).ToArray();

        Assert.Equal("Area = 6, Perimeter = 12", lines[0]);
        Assert.Equal(FormattableString.Invariant($"Area = {9 * Math.PI:0.####}, Circumference = {6 * Math.PI:0.####}"), lines[1]);
        Assert.Equal("Area = 64, Perimeter = 32", lines[2]);
        var sweep = 110.0 * Math.PI / 180.0; // 350 to 100 degrees, closed by its chord
        Assert.Equal(FormattableString.Invariant($"Area = {8.0 * (sweep - Math.Sin(sweep)):0.####}, Length = {4.0 * sweep:0.####}"), lines[3]);
    }

    [Fact]
    public async Task A_polyline_is_exploded_and_joined_again()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var before = Outline(talk.State.Drawing!, 3);
        await talk.TypeAsync("EXPLODE", "H", "A4", "");
        Assert.Equal((7, 4), (talk.State.Drawing!.Entities.Count, talk.State.Previous.Count));
        Assert.All(talk.State.Previous, entity => Assert.Equal(CurveType.Line, talk.State.Drawing.Entities[entity].Type));
        await talk.TypeAsync("J", "P", "");
        var joined = talk.State.Previous.Single();

        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
        Assert.Equal((CurveType.LwPolyline, true), (talk.State.Drawing.Entities[joined].Type, talk.State.Drawing.Entities[joined].Closed));
        Assert.Equal(before, Outline(talk.State.Drawing, joined));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("X", "H", "A1", ""));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("J", "ALL", ""));
    }

    [Fact]
    public async Task Join_turns_what_runs_backwards_and_leaves_a_branch_apart()
    {
        await using var talk = new CommandTestSession();
        var drawing = new DrawingBuilder().Line(0, 0, 10, 0).Line(20, 5, 10, 0).Arc(20, 10, 5, 270, 360).Line(100, 0, 110, 0).Line(110, 0, 120, 0).Line(110, 0, 110, 9).Build();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = drawing });
        await talk.TypeAsync("JOIN", "ALL", "");
        var joined = talk.State.Previous.Select(entity => Outline(talk.State.Drawing!, entity)).ToList();

        Assert.Equal(2, joined.Count);
        Assert.Equal((new Point2D(0, 0), 3), (joined[0][0].Start, joined[0].Count));
        Assert.True(joined[0].Zip(joined[0].Skip(1)).All(pair => pair.First.End.IsNear(pair.Second.Start, 1e-9)));
        Assert.Equal(3, talk.State.Drawing!.Entities.Count);
    }

    [Fact]
    public async Task Overkill_erases_what_was_drawn_twice_in_either_direction_and_a_part_is_no_whole()
    {
        await using var talk = new CommandTestSession();
        var drawing = new DrawingBuilder().Line(0, 0, 10, 0).Line(10, 0, 0, 0).Square(0, 0, 10).Circle(5, 5, 2).Circle(5, 5, 2).Build();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = drawing });
        await talk.TypeAsync("OVERKILL", "ALL", "", "");

        Assert.Equal(["A1", "A3", "A4"], Enumerable.Range(0, talk.State.Drawing!.Entities.Count).Select(entity => talk.State.Drawing.SourceOf(entity).Handle));
        Assert.Contains("2 duplicates erased.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Arrays_copy_in_rows_and_around_a_point()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("ARRAY", "H", "A1", "", "R", "2", "3", "100", "50");
        Assert.Equal(9, talk.State.Drawing!.Entities.Count);
        Assert.Equal(new Point2D(100, 100), Outline(talk.State.Drawing, 8)[0].Start);
        await talk.TypeAsync("U", "AR", "H", "A1", "", "PO", "0,0", "4", "");
        Assert.Equal(7, talk.State.Drawing!.Entities.Count);
        var turned = Outline(talk.State.Drawing, 4)[0].End;
        Assert.True(turned.IsNear(new Point2D(0, 10), 1e-9), turned.ToString());
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("AR", "ALL", "", "R", "1000", "1000"));
    }

    [Fact]
    public async Task The_origin_is_put_where_it_is_wanted()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("ORIGIN", "L");
        var box = talk.Session.View.ExtentsOf(talk.State.Drawing!);
        Assert.Equal((0.0, 0.0), (box.MinX, box.MinY));
        await talk.TypeAsync("ORIGIN", "5,1");
        Assert.Equal(new Point2D(-5, -1), new Point2D(talk.Session.View.ExtentsOf(talk.State.Drawing!).MinX, talk.Session.View.ExtentsOf(talk.State.Drawing!).MinY));
    }

    [Fact]
    public async Task What_is_hidden_is_neither_picked_nor_cut_and_comes_back_and_nothing_else_does()
    {
        await using var talk = new CommandTestSession();
        var drawing = new DrawingBuilder().Line(0, 0, 10, 0).Line(0, 5, 10, 5).Square(20, 0, 5).Line(0, 9, 10, 9).Hidden().Line(0, 20, 10, 20).Build();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = drawing });
        await talk.TypeAsync("HIDEOBJECTS", "H", "A2", "H", "A4", "");
        Assert.Equal(2, DrawingPick.Visible(talk.State.Drawing!).Count());
        Assert.Equal(5, JobPreparation.Analyse(talk.State.Drawing!, talk.State.Settings).Count);

        await talk.TypeAsync("ERASE", "H", "A1", "", "EXPLODE", "ALL", "", "UNISOLATEOBJECTS");

        Assert.Equal(["A2", "A4"], DrawingPick.Visible(talk.State.Drawing!).Select(entity => talk.State.Drawing!.SourceOf(entity).Handle).Where(handle => handle is "A1" or "A2" or "A4" or "A5"));
        Assert.Equal(6, DrawingPick.Visible(talk.State.Drawing!).Count());
        await talk.TypeAsync("U", "U", "U", "U");
        Assert.Equal(4, DrawingPick.Visible(talk.State.Drawing!).Count());
    }

    private static List<Segment> Outline(Drawing drawing, int index)
    {
        var entity = drawing.Entities[index];
        return [.. Enumerable.Range(entity.FirstPart, entity.PartCount).Select(part => drawing.SegmentOf(drawing.Parts[part]))];
    }
}
