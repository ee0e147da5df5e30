using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.CommandLanguage;

/// <summary>A prompt states the purpose of a point and its base point for the canvas.</summary>
public class PointRequestTests
{
    private static readonly PointRequest s_object = new(PointPurpose.Object, null);
    private static readonly PointRequest s_from = new(PointPurpose.Place, new Point2D(1, 2));
    private static readonly PointRequest s_corner = new(PointPurpose.Corner, new Point2D(1, 2));

    public static TheoryData<string[], PointRequest?> Asked => new()
    {
        { [], null },
        { ["LAYER"], null },
        { ["MOVE"], s_object },
        { ["MOVE", "100,100"], new PointRequest(PointPurpose.Corner, new Point2D(100, 100)) },
        { ["MOVE", "W", "1,2"], s_corner },
        { ["MOVE", "L", ""], PointRequest.Place },
        { ["MOVE", "L", "", "1,2"], s_from },
        { ["COPY", "L", "", "1,2"], s_from },
        { ["MIRROR", "L", "", "1,2"], s_from },
        { ["ROTATE", "L", "", "1,2"], s_from },
        { ["ROTATE", "L", "", "1,2", "R"], PointRequest.Place },
        { ["ROTATE", "L", "", "5,5", "R", "1,2"], s_from },
        { ["SCALE", "L", "", "1,2"], s_from },
        { ["SCALE", "L", "", "1,2", "R", "4"], s_from },
        { ["DIST", "1,2"], s_from },
        { ["AREA", "0,0", "1,2"], s_from },
        { ["PAN", "1,2"], s_from },
        { ["MOVE", "W"], PointRequest.FirstCorner },
        { ["ZOOM"], PointRequest.FirstCorner },
        { ["ZOOM", "W"], PointRequest.FirstCorner },
        { ["ZOOM", "1,2"], s_corner },
        { ["ENTER"], s_object },
    };

    [Theory]
    [MemberData(nameof(Asked))]
    public async Task A_prompt_says_what_is_to_be_pointed_at(string[] typed, PointRequest? aim)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync(typed);

        Assert.Equal(aim, talk.Session.Prompt.PointRequest is { } asked ? asked with { Ghost = null } : null);
    }

    /// <summary>The line from 0,0 to 10,0 zoomed in so far that the pick radius is a hundredth of a unit.</summary>
    [Fact]
    public async Task A_pick_reaches_as_far_as_what_is_seen_is_large()
    {
        await using var talk = CommandTestSession.WithDrawing();
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("SELECT", "5,-0.2"));
        Assert.Contains("1 found", talk.Said, StringComparison.Ordinal);
        talk.Session.View.SetCentre(new Point2D(5, 0), 0.5);
        await talk.TypeAsync("5,-0.2");

        Assert.Equal(PointPurpose.Corner, talk.Session.Prompt.PointRequest!.Purpose);
    }

    [Fact]
    public async Task A_copy_leaves_what_is_copied_where_it_is()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("CO", "H", "A1", "", "1,1", "@0,30", "");
        var drawing = talk.State.Drawing!;

        Assert.Equal(5, drawing.Entities.Count);
        Assert.Equal(new Point2D(0, 0), DrawingPick.Segments(drawing, 0).First().Start);
        Assert.Equal(new Point2D(0, 30), DrawingPick.Segments(drawing, 4).First().Start);
        await talk.TypeAsync("CP", "H", "A1", "", "D", "5,6");
        Assert.Equal(new Point2D(5, 6), DrawingPick.Segments(talk.State.Drawing!, 5).First().Start);
    }

    /// <summary>Temporarily hidden objects are not saved as hidden.</summary>
    [Fact]
    public async Task Hiding_objects_and_showing_them_is_no_edit()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "HIDEOBJECTS", "L", "");
        Assert.False(talk.Session.Document.IsEdited);
        await talk.TypeAsync("ERASE", "L", "");
        Assert.True(talk.Session.Document.IsEdited);
        await talk.TypeAsync("UNISOLATEOBJECTS");
        Assert.True(talk.Session.Document.IsEdited);
        await talk.TypeAsync("HIDEOBJECTS", "L", "", "SAVEAS", "out.dxf", "UNISOLATEOBJECTS");
        Assert.False(talk.Session.Document.IsEdited);
        await talk.TypeAsync("UNDO", "2");
        Assert.False(talk.Session.Document.IsEdited);
        await talk.TypeAsync("UNDO", "2");
        Assert.True(talk.Session.Document.IsEdited); // out.dxf no longer has the erased one.
    }

    [Fact]
    public async Task Leaving_a_drawing_whose_edits_are_in_no_file_is_told()
    {
        const string Warning = "gasket.dxf has unsaved changes. UNDO returns to it.";
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "OPEN", CommandTestSession.Sample("gasket.dxf"), "CLOSE");
        Assert.DoesNotContain(Warning, talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("U", "ERASE", "L", "", "CLOSE");
        Assert.Equal(1, talk.Said.Split(Warning).Length - 1);
        await talk.TypeAsync("U", "OPEN", CommandTestSession.Sample("paper-001.dxf"));
        Assert.Equal(2, talk.Said.Split(Warning).Length - 1);
        await talk.TypeAsync("U");
        Assert.Equal(69, talk.State.Drawing!.Entities.Count);
    }

    [Fact]
    public async Task A_drawing_is_edited_until_it_is_written_or_as_it_was()
    {
        await using var talk = new CommandTestSession();
        Assert.False(talk.Session.Document.IsEdited);
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"));
        Assert.False(talk.Session.Document.IsEdited);
        await talk.TypeAsync("ERASE", "L", "");
        Assert.True(talk.Session.Document.IsEdited);
        await talk.TypeAsync("U");
        Assert.False(talk.Session.Document.IsEdited);
        await talk.TypeAsync("REDO", "SAVEAS", "out.dxf");
        Assert.False(talk.Session.Document.IsEdited);
        await talk.TypeAsync("MOVE", "ALL", "", "0,0", "1,1", "CLOSE");
        Assert.False(talk.Session.Document.IsEdited);
    }
}
