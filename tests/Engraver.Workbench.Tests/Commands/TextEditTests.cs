using Engraver.TestKit;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>Texts are edited when they are selected. Points cannot be selected; they move with an edit of everything else that is visible, and otherwise do
/// not, which is reported.</summary>
public class TextEditTests
{
    /// <summary>Two lines (the second on a separate layer), a fitted text on layer 0, a wrapped one on layer NOTES.</summary>
    private static readonly (int, object)[] s_entities =
    [
        (0, "LINE"), (5, "A1"), (8, "0"), (10, 0.0), (20, 0.0), (11, 10.0), (21, 0.0),
        (0, "LINE"), (5, "A2"), (8, "NOTES"), (10, 0.0), (20, 5.0), (11, 10.0), (21, 5.0),
        (0, "TEXT"), (8, "0"), (10, 2.0), (20, 1.0), (30, 3.0), (40, 2.0), (1, "fit"), (50, 30.0), (72, 5), (11, 6.0), (21, 1.0),
        (0, "MTEXT"), (8, "NOTES"), (10, 1.0), (20, 4.0), (40, 1.0), (41, 20.0), (71, 1), (1, "note"),
        (0, "POINT"), (8, "0"), (10, 3.0), (20, 2.0), (30, 9.0), (0, "POINT"), (8, "NOTES"), (10, -1.0), (20, 0.0),
    ];

    [Fact]
    public async Task Moving_everything_moves_the_texts_and_undo_brings_them_back()
    {
        await using var talk = await OpenAsync();
        var before = talk.State.Drawing!.Texts;
        await talk.TypeAsync("MOVE", "ALL", "", "0,0", "5,7");

        Assert.Equal((7.0, 8.0, 3.0), Place(talk, 0));
        Assert.Equal((11.0, 8.0), (talk.State.Drawing!.Texts[0].End!.Value.X, talk.State.Drawing.Texts[0].End!.Value.Y));
        Assert.Equal((6.0, 11.0, 0.0), Place(talk, 1));
        Assert.DoesNotContain("not changed", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("U");
        Assert.Same(before, talk.State.Drawing!.Texts);
    }

    [Fact]
    public async Task Turning_and_scaling_take_height_width_and_direction_along()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("ROTATE", "ALL", "", "0,0", "90", "SCALE", "P", "", "0,0", "2");
        var (line, note) = (talk.State.Drawing!.Texts[0], talk.State.Drawing.Texts[1]);

        Assert.Equal((-2.0, 4.0), (Math.Round(line.Position.X, 9), Math.Round(line.Position.Y, 9)));
        Assert.Equal((4.0, 120.0), (line.Height, Math.Round(line.Rotation.Degrees, 9)));
        Assert.All(talk.State.Drawing.Texts, text => Assert.True((text.Inserts.Apply(text.Written.Insertion) - text.Position).Length < 1e-9));
        Assert.Equal((2.0, 40.0, 90.0), (note.Height, note.FrameWidth, Math.Round(note.Rotation.Degrees, 9)));
        Assert.False(line.Mirrored);
    }

    [Fact]
    public async Task A_mirrored_drawing_has_mirrored_texts()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("MIRRTEXT", "1", "MIRROR", "ALL", "", "0,0", "0,1", "Yes");

        Assert.Equal((-2.0, 1.0, 3.0), Place(talk, 0));
        Assert.Equal((-1.0, 1.0), (talk.State.Drawing!.Texts[0].Inserts.XAxis.X, talk.State.Drawing.Texts[0].Inserts.YAxis.Y));
        Assert.Equal((true, 150.0), (talk.State.Drawing!.Texts[0].Mirrored, Math.Round(talk.State.Drawing.Texts[0].Rotation.Degrees, 9)));
        Assert.Equal(2, talk.State.Drawing.Texts.Count);
    }

    [Fact]
    public async Task Copies_and_arrays_of_everything_have_texts_of_their_own()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("COPY", "ALL", "", "0,0", "100,0", "");
        Assert.Equal((4, 102.0), (talk.State.Drawing!.Texts.Count, talk.State.Drawing.Texts[2].Position.X));
        await talk.TypeAsync("U", "ARRAY", "ALL", "", "R", "1", "3", "50");

        Assert.Equal([2.0, 1.0, 52.0, 51.0, 102.0, 101.0], talk.State.Drawing!.Texts.Select(text => text.Position.X));
    }

    [Fact]
    public async Task Erasing_everything_erases_the_texts()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("ERASE", "ALL", "");

        Assert.Empty(talk.State.Drawing!.Texts);
    }

    [Fact]
    public async Task An_edit_of_a_part_leaves_the_texts()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("MOVE", "H", "A1", "", "0,0", "5,7", "ERASE", "H", "A1", "");

        Assert.Equal((2.0, 1.0, 3.0), Place(talk, 0));
        Assert.Equal(2, talk.State.Drawing!.Texts.Count);
    }

    [Fact]
    public async Task What_cannot_be_seen_stays()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("LAYER", "Freeze", "NOTES", "", "MOVE", "ALL", "", "0,0", "5,7");

        Assert.Equal((7.0, 8.0, 3.0), Place(talk, 0));
        Assert.Equal((1.0, 4.0, 0.0), Place(talk, 1));
    }

    [Fact]
    public async Task The_origin_takes_all_along_also_what_cannot_be_seen()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("LAYER", "Freeze", "NOTES", "", "ORIGIN", "1,1");

        Assert.Equal((1.0, 0.0, 3.0), Place(talk, 0));
        Assert.Equal((0.0, 3.0, 0.0), Place(talk, 1));
    }

    [Fact]
    public async Task Points_go_along_as_texts_do()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("MOVE", "ALL", "", "0,0", "5,7");
        Assert.Equal([(8.0, 9.0, 9.0), (4.0, 7.0, 0.0)], Points(talk));
        await talk.TypeAsync("U", "COPY", "ALL", "", "0,0", "100,0", "");
        Assert.Equal([(3.0, 2.0, 9.0), (-1.0, 0.0, 0.0), (103.0, 2.0, 9.0), (99.0, 0.0, 0.0)], Points(talk));
        await talk.TypeAsync("U", "MOVE", "H", "A1", "", "0,0", "5,7", "U");
        Assert.Contains("2 points not changed", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("LAYER", "Freeze", "NOTES", "", "ERASE", "ALL", "");
        Assert.Equal([(-1.0, 0.0, 0.0)], Points(talk));
        await talk.TypeAsync("U");
        Assert.Equal([(3.0, 2.0, 9.0), (-1.0, 0.0, 0.0)], Points(talk));
    }

    private static IEnumerable<(double X, double Y, double Z)> Points(CommandTestSession talk) => talk.State.Drawing!.Points.Select(point => (Math.Round(point.Position.X, 9), Math.Round(point.Position.Y, 9), point.Position.Z));

    private static (double X, double Y, double Z) Place(CommandTestSession talk, int text)
    {
        var place = talk.State.Drawing!.Texts[text].Position;
        return (Math.Round(place.X, 9), Math.Round(place.Y, 9), place.Z);
    }

    private static async Task<CommandTestSession> OpenAsync()
    {
        var talk = new CommandTestSession();
        await File.WriteAllBytesAsync(talk.PathOf("in.dxf"), new DxfText().Header("AC1015", 4).Section("ENTITIES", s_entities).End().ToAscii());
        await talk.TypeAsync("OPEN", "in.dxf");
        Assert.Equal(2, talk.State.Drawing!.Texts.Count);
        return talk;
    }
}
