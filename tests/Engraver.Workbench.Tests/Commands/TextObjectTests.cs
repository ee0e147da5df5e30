using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>Texts as objects of commands, and the commands that write them.</summary>
public class TextObjectTests
{
    private static readonly (int, object)[] s_entities =
    [
        (0, "LINE"), (5, "A1"), (8, "0"), (10, 0.0), (20, 0.0), (11, 40.0), (21, 0.0),
        (0, "TEXT"), (5, "A2"), (8, "0"), (10, 0.0), (20, 5.0), (40, 5.0), (1, "LH"),
        (0, "TEXT"), (5, "A3"), (8, "0"), (10, 20.0), (20, 5.0), (40, 5.0), (1, "RST"),
    ];

    [Fact]
    public async Task A_text_is_moved_copied_turned_scaled_and_erased()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("MOVE", "H", "A2", "", "0,0", "5,7");
        Assert.Equal([(5.0, 12.0), (20.0, 5.0)], Places(talk));
        await talk.TypeAsync("COPY", "P", "", "0,0", "1,0", "2,0", "");
        Assert.Equal([(5.0, 12.0), (20.0, 5.0), (6.0, 12.0), (7.0, 12.0)], Places(talk));
        Assert.Equal(4, talk.State.Drawing!.Texts.Select(text => text.Handle).Distinct().Count());
        await talk.TypeAsync("U", "ROTATE", "H", "A3", "", "20,5", "90", "SCALE", "P", "", "20,5", "2");
        Assert.Equal((10.0, 90.0), (talk.State.Drawing!.Texts[1].Height, Math.Round(talk.State.Drawing.Texts[1].Rotation.Degrees, 9)));
        await talk.TypeAsync("ERASE", "H", "A2", "");
        Assert.Equal((1, 1), (talk.State.Drawing!.Entities.Count, talk.State.Drawing.Texts.Count));
        await talk.TypeAsync("U");
        Assert.Equal(2, talk.State.Drawing!.Texts.Count);
    }

    [Fact]
    public async Task Previous_names_the_same_text_after_curves_were_added()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("MOVE", "H", "A2", "", "0,0", "5,7", "LINE", "0,0", "1,1", "2,0", "", "MOVE", "P", "", "0,0", "1,0");

        Assert.Equal([(6.0, 12.0), (20.0, 5.0)], Places(talk));
    }

    [Fact]
    public async Task Texts_are_found_by_a_click_a_window_and_a_crossing()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("SELECT", OnLetter(talk), "");
        Assert.Equal([1], talk.State.Selection);
        await talk.TypeAsync("SELECT", "W", "-1,4", "15,11", "");
        Assert.Equal([1], talk.State.Selection);
        await talk.TypeAsync("SELECT", "C", "2,-1", "25,6", "");
        Assert.Equal([0, 1, 2], talk.State.Selection.Order());
        await talk.TypeAsync("SELECT", "L", "");
        Assert.Equal([2], talk.State.Selection);
    }

    /// <summary>No command of curves meets the index of a text.</summary>
    [Theory]
    [InlineData("JOIN")]
    [InlineData("REVERSE")]
    [InlineData("EXPLODE")]
    [InlineData("OVERKILL")]
    [InlineData("HIDEOBJECTS")]
    [InlineData("SACEPATH")]
    [InlineData("POCKET")]
    public async Task A_command_of_curves_refuses_a_selection_of_texts(string command)
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("SELECT", "H", "A2", "H", "A3", "");
        var before = talk.State.Drawing;
        var result = await talk.Session.EnterAsync(command, CancellationToken.None);

        Assert.Contains("texts", Assert.IsType<InputResult.Failed>(result).Message, StringComparison.Ordinal);
        Assert.Same(before, talk.State.Drawing);
    }

    [Fact]
    public async Task A_mirrored_text_stays_readable_unless_MIRRTEXT_is_1()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("MIRROR", "H", "A3", "", "0,0", "0,1", "Yes");
        var (readable, box) = (talk.State.Drawing!.Texts[1], BoxOf(talk, 1));
        Assert.Equal((false, 0.0), (readable.Mirrored, Math.Round(readable.Rotation.Degrees, 9) % 360.0));
        await talk.TypeAsync("U", "MIRRTEXT", "1", "MIRROR", "H", "A3", "", "0,0", "0,1", "Yes");
        var (inverted, same) = (talk.State.Drawing!.Texts[1], BoxOf(talk, 1));
        Assert.True(inverted.Mirrored);
        Assert.Equal((Math.Round(same.MinX, 6), Math.Round(same.MaxX, 6)), (Math.Round(box.MinX, 6), Math.Round(box.MaxX, 6)));
    }

    [Fact]
    public async Task TEXT_writes_lines_below_each_other_in_one_step()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("TEXT", "10,20", "3", "0", "name %%c5", "a^b", "");
        var texts = talk.State.Drawing!.Texts;

        Assert.Equal(["name ⌀5", "a^b"], texts.Skip(2).Select(text => text.Content));
        Assert.Equal((10.0, 15.0), (texts[3].Position.X, Math.Round(texts[3].Position.Y, 9)));
        Assert.True(ShownDrawing.Of(talk.State.Drawing).Entities[3].PartCount > 0);
        await talk.TypeAsync("TEXT", "", "2", "0", "below", "");
        Assert.Equal((10.0, 10.0), (Math.Round(talk.State.Drawing!.Texts[4].Position.X, 9), Math.Round(talk.State.Drawing.Texts[4].Position.Y, 9)));
        await talk.TypeAsync("U", "U");
        Assert.Equal(2, talk.State.Drawing!.Texts.Count);
    }

    [Theory]
    [InlineData("Left", 0, 0)]
    [InlineData("MC", 1, 2)]
    [InlineData("TR", 2, 3)]
    [InlineData("BL", 0, 1)]
    [InlineData("Middle", 4, 0)]
    public async Task TEXT_knows_the_justifications(string name, int horizontal, int vertical)
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("TEXT", "Justify", name, "100,50", "4", "0", "HHH", "");
        var written = talk.State.Drawing!.Texts[^1].Written;

        Assert.Equal((horizontal, vertical), (written.Horizontal, written.Vertical));
        Assert.Equal((100.0, 50.0), (talk.State.Drawing.Texts[^1].Position.X, talk.State.Drawing.Texts[^1].Position.Y));
    }

    [Fact]
    public async Task Fit_and_Align_take_two_points()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("TEXT", "J", "Fit", "0,30", "60,30", "4", "FIT", "", "TEXT", "J", "Align", "0,50", "60,50", "ALIGN", "");
        var (fit, align) = (BoxOf(talk, 2), BoxOf(talk, 3));

        Assert.Equal(4.0, fit.Height, 0.5);
        Assert.InRange(fit.Width, 50.0, 60.0);
        Assert.InRange(align.Width, 50.0, 60.0);
    }

    [Fact]
    public async Task MTEXT_escapes_what_was_typed()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("MTEXT", "0,50", "J", "MC", "H", "4", "40,20", @"{a\b}", "second", "");
        var text = talk.State.Drawing!.Texts[^1];

        Assert.Equal((@"\{a\\b\}\Psecond", "{a\\b}\nsecond"), (text.Written.Raw, text.Content));
        Assert.Equal((5, 40.0, 4.0, 20.0, 35.0), (text.Written.Paragraphs!.Attachment, text.FrameWidth, text.Height, text.Position.X, text.Position.Y));
        Assert.Equal(3, talk.State.Drawing.Texts.Count);
    }

    [Fact]
    public async Task DDEDIT_changes_the_string_and_undo_brings_it_back()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("DDEDIT", OnLetter(talk), "NEW", "5,7", "", "");
        Assert.Equal("NEW", talk.State.Drawing!.Texts[0].Content);
        await talk.TypeAsync("U");
        Assert.Equal("LH", talk.State.Drawing!.Texts[0].Content);
    }

    [Fact]
    public async Task STYLE_creates_a_style_that_TEXT_uses()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("STYLE", "Wide", "engraver", "6", "2", "15", "No", "No", "TEXT", "0,30", "0", "W", "");
        var text = talk.State.Drawing!.Texts[^1];

        Assert.Equal(("Wide", 6.0, 2.0, 15.0), (text.Style, text.Height, text.WidthFactor, text.Oblique.Degrees));
        await talk.TypeAsync("STYLE", "Wide", "no-such-font", "0", "1", "0", "No", "No");
        Assert.Contains("no-such-font", talk.Said, StringComparison.Ordinal);
        Assert.Equal(0.0, talk.State.Drawing!.Styles.Single(style => style.Name == "Wide").FixedHeight);
    }

    [Fact]
    public async Task TXTEXP_leaves_the_letters_as_curves()
    {
        await using var talk = await OpenAsync();
        var letters = BoxOf(talk, 0);
        await talk.TypeAsync("TXTEXP", "H", "A2", "");

        Assert.Equal(["RST"], talk.State.Drawing!.Texts.Select(text => text.Content));
        Assert.True(talk.State.Drawing.Entities.Count > 2);
        Assert.Equal(letters, DrawingPick.BoundsOf(talk.State.Drawing, Enumerable.Range(1, talk.State.Drawing.Entities.Count - 1)));
        await talk.TypeAsync("U");
        Assert.Equal((1, 2), (talk.State.Drawing!.Entities.Count, talk.State.Drawing.Texts.Count));
    }

    [Theory]
    [InlineData("COntents", "X^2", "X^2")]
    [InlineData("TextHeight", "7.5", "7.5")]
    [InlineData("TextRotation", "30", "30")]
    [InlineData("WidthFactor", "0.8", "0.8")]
    [InlineData("OBlique", "12", "12")]
    [InlineData("Justify", "MC", "MC")]
    [InlineData("LAyer", "0", "0")]
    public async Task A_property_of_a_moved_text_is_changed(string property, string value, string shown)
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("ROTATE", "H", "A2", "", "0,0", "20", "CHPROP", "H", "A2", "", property, value);
        var values = Engraver.Workbench.Commands.Properties.ObjectProperties.Of(talk.State.Drawing!, [1], new Engraver.Workbench.CommandLanguage.DisplayPrecision(4, 2));

        var read = values.Single(one => one.Property.Name == property).Value;
        Assert.Equal(shown, read.Contains('.', StringComparison.Ordinal) ? read.TrimEnd('0').TrimEnd('.') : read);
    }

    /// <summary>Written as text and read again, the letters are the same, wherever an edit has put them.</summary>
    [Theory]
    [InlineData("MOVE", "ALL", "", "0,0", "5,7")]
    [InlineData("ROTATE", "ALL", "", "0,0", "33")]
    [InlineData("SCALE", "ALL", "", "1,1", "2.5")]
    [InlineData("MIRROR", "ALL", "", "0,0", "3,1", "Yes")]
    [InlineData("MIRRTEXT", "1", "MIRROR", "ALL", "", "0,0", "3,1", "Yes")]
    public async Task SAVEAS_writes_texts_with_their_styles(params string[] edit)
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync(["STYLE", "Slanted", "engraver", "0", "1.5", "10", "No", "No", "TEXT", "J", "MR", "50,30", "4", "25", "new %%d text", "", "TEXT", "J", "Fit", "0,60", "50,70", "4", "fitted", "", "MTEXT", "80,50", "H", "4", "J", "MC", "110,20", "several words wrap", "", .. edit, "SAVEAS", "out.dxf"]);
        var before = Letters(talk.State.Drawing!);
        await talk.TypeAsync("OPEN", "out.dxf");

        Assert.Equal(["LH", "RST", "new ° text", "fitted", "several words wrap"], talk.State.Drawing!.Texts.Select(text => text.Content));
        Assert.Equal(before, Letters(talk.State.Drawing!));
    }

    [Fact]
    public async Task CNCTEXT_is_for_this_drawing()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("CNCTEXT", "Yes");
        Assert.Equal(CutChoice.Text, talk.State.Settings.Cut);
        await talk.TypeAsync("OPEN", "in.dxf");
        Assert.Equal(CutChoice.None, talk.State.Settings.Cut);
        await talk.TypeAsync("CNCCUT", "32", "OPEN", "in.dxf");
        Assert.Equal(CutChoice.Text, talk.State.Settings.Cut);
    }

    private static IEnumerable<(double, double, double, double)> Letters(Drawing drawing)
    {
        var shown = ShownDrawing.Of(drawing);
        return [.. Enumerable.Range(drawing.Entities.Count, drawing.Texts.Count).SelectMany(entity => DrawingPick.Segments(shown, entity)).Select(part => (Math.Round(part.Start.X, 6) + 0.0, Math.Round(part.Start.Y, 6) + 0.0, Math.Round(part.End.X, 6) + 0.0, Math.Round(part.End.Y, 6) + 0.0))];
    }

    /// <summary>A point of the first letter of the first text.</summary>
    private static string OnLetter(CommandTestSession talk)
    {
        var at = DrawingPick.Segments(ShownDrawing.Of(talk.State.Drawing!), talk.State.Drawing!.Entities.Count).First().PointAt(0.5);
        return FormattableString.Invariant($"{at.X:R},{at.Y:R}");
    }

    private static Bounds2D BoxOf(CommandTestSession talk, int text) => DrawingPick.BoundsOf(ShownDrawing.Of(talk.State.Drawing!), [talk.State.Drawing!.Entities.Count + text]);

    private static IEnumerable<(double X, double Y)> Places(CommandTestSession talk) => talk.State.Drawing!.Texts.Select(text => (Math.Round(text.Position.X, 9), Math.Round(text.Position.Y, 9)));

    private static async Task<CommandTestSession> OpenAsync()
    {
        var talk = new CommandTestSession();
        await File.WriteAllBytesAsync(talk.PathOf("in.dxf"), new DxfText().Header("AC1015", 4).Section("ENTITIES", s_entities).End().ToAscii());
        await talk.TypeAsync("OPEN", "in.dxf");
        return talk;
    }
}
