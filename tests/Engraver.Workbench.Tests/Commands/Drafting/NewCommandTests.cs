using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Drafting;

public class NewCommandTests
{
    [Fact]
    public async Task An_empty_drawing_in_millimetres_with_layer_0_and_nothing_to_save()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("NEW");
        var drawing = talk.State.Drawing!;

        Assert.Equal((0, "0", "mm", 4, true), (drawing.Entities.Count, Assert.Single(drawing.Layers).Name, drawing.Unit.Name, drawing.Unit.Code, drawing.IsNew));
        Assert.False(talk.Session.Document.IsEdited);
        Assert.False(talk.Session.Document.HasFile);
        await talk.TypeAsync("NEW");
        Assert.Equal("Drawing2.dxf", talk.Session.Document.FilePath);
    }

    [Fact]
    public async Task What_is_open_and_not_saved_is_told_and_comes_back_with_undo()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("L", "0,50", "1,50", "", "NEW");
        Assert.Contains("unsaved changes", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("U");

        Assert.Equal(5, talk.State.Drawing!.Entities.Count);
    }

    [Fact]
    public async Task Saving_asks_for_a_name_once_and_then_knows_the_file()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("NEW", "C", "5,5", "3", "QSAVE");
        Assert.Contains("name of DXF file", talk.Session.Prompt.Text, StringComparison.Ordinal);
        await talk.TypeAsync("mine.dxf");
        Assert.True(talk.Session.Document.HasFile);
        Assert.False(talk.Session.Document.IsEdited);
        Assert.Equal(talk.PathOf("mine.dxf"), talk.Session.Document.FilePath);
        await talk.TypeAsync("L", "0,0", "1,0", "", "QSAVE", "Yes", "OPEN", "mine.dxf");

        Assert.Equal(["Circle (5,5 r3)", "Line (0,0 1,0)"], CurveText.Of(talk.State.Drawing));
        Assert.False(talk.State.Drawing!.IsNew);
        Assert.Equal("mm", talk.State.Drawing.Unit.Name);
    }

    [Theory]
    [InlineData("Yes", true)]
    [InlineData("No", false)]
    public async Task A_person_is_asked_whether_edits_are_saved_first(string answer, bool saves)
    {
        var folder = Directory.CreateTempSubdirectory("engraver-new-");
        await using var session = new CommandSession(new CommandEnvironment { Folder = folder.FullName, RunJournalFolder = folder.FullName, RunNeedsArming = true }, CommandCatalog.Built());
        foreach (var input in new[] { "NEW", "CIRCLE", "5,5", "3", "SAVEAS", "mine.dxf", "CIRCLE", "9,9", "1", "NEW" }) await session.EnterAsync(input, CancellationToken.None);
        Assert.Equal("Save changes to mine.dxf? [Yes/No] <Yes>:", session.Prompt.Text);
        await session.EnterAsync(answer, CancellationToken.None);
        Assert.Empty(CurveText.Of(session.Document.Current.Drawing));
        await session.EnterAsync("OPEN", CancellationToken.None);
        await session.EnterAsync("mine.dxf", CancellationToken.None);
        var drawn = CurveText.Of(session.Document.Current.Drawing);
        folder.Delete(recursive: true);

        Assert.Equal(saves ? 2 : 1, drawn.Length);
    }

    [Fact]
    public async Task Undo_after_saving_still_knows_the_file()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("C", "5,5", "3", "C", "9,9", "1", "SAVEAS", "mine.dxf", "U");
        Assert.Equal((1, talk.PathOf("mine.dxf"), true), (talk.State.Drawing!.Entities.Count, talk.Session.Document.FilePath, talk.Session.Document.HasFile));

        Assert.True(talk.Session.Document.IsEdited);
    }

    /// <summary>Everything that processes a drawing accepts an empty one.</summary>
    [Theory]
    [InlineData("CHECK")]
    [InlineData("LIST", "ALL", "")]
    [InlineData("ZOOM", "E")]
    [InlineData("AUTOSEQUENCE")]
    [InlineData("DISCONTINUITIES")]
    [InlineData("TABLE", "D", "Csv", "t.csv")]
    [InlineData("PLOT", "D", "p.svg")]
    [InlineData("POST", "galil", "p.dmc")]
    [InlineData("SAVEAS", "empty.dxf", "OPEN", "empty.dxf")]
    [InlineData("REPORT", "r.html")]
    [InlineData("LAYER", "?", "")]
    [InlineData("CLOSE")]
    public async Task Commands_take_an_empty_drawing(params string[] inputs)
    {
        await using var talk = new CommandTestSession();
        var result = await talk.TypeAsync(["NEW", .. inputs]);

        Assert.False(result is InputResult.Failed { Exception: not null } or InputResult.AwaitingInput, talk.Said);
    }
}
