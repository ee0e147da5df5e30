using Engraver.Core.Drawings;
using Engraver.TestKit;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>SAVEAS keeps everything in the drawing, and reports other content of the file.</summary>
public class SaveAsTests
{
    private static readonly (int, object)[] s_knots = [(40, 0.0), (40, 0.0), (40, 0.0), (40, 0.0), (40, 1.0), (40, 1.0), (40, 1.0), (40, 1.0)];

    private static readonly (int, object)[] s_raised =
    [
        (0, "LINE"), (10, 1.0), (20, 2.0), (30, 3.0), (11, 4.0), (21, 5.0), (31, -6.0),
        (0, "ARC"), (10, 5.0), (20, 0.0), (30, 7.0), (40, 2.0), (210, 0.0), (220, 0.0), (230, -1.0), (50, 10.0), (51, 80.0),
        (0, "CIRCLE"), (10, 5.0), (20, 0.0), (30, 7.0), (40, 2.0),
        (0, "LWPOLYLINE"), (90, 3), (70, 1), (38, 4.5), (10, 0.0), (20, 0.0), (42, 1.0), (10, 5.0), (20, 0.0), (10, 2.0), (20, 5.0),
        (0, "POLYLINE"), (66, 1), (70, 9), (0, "VERTEX"), (10, 0.0), (20, 0.0), (30, 1.0), (70, 32), (0, "VERTEX"), (10, 3.0), (20, 0.0), (30, 2.0), (70, 32), (0, "VERTEX"), (10, 3.0), (20, 3.0), (30, 0.0), (70, 32), (0, "SEQEND"),
        (0, "ELLIPSE"), (10, 0.0), (20, 0.0), (30, 2.5), (11, 5.0), (21, 0.0), (31, 0.0), (40, 0.5), (41, 0.0), (42, 3.0),
        (0, "CIRCLE"), (10, 5.0), (20, 0.0), (30, 7.0), (40, 2.0), (210, 1.0), (220, 0.0), (230, 1.0),
        (0, "SPLINE"), (70, 8), (71, 3), (72, 8), (73, 4), .. s_knots, (10, 0.0), (20, 0.0), (30, 0.0), (10, 1.0), (20, 2.0), (30, 1.0), (10, 3.0), (20, 2.0), (30, 4.0), (10, 4.0), (20, 0.0), (30, 9.0),
    ];

    private static readonly (int, object)[] s_texts =
    [
        (0, "TEXT"), (8, "CUT"), (10, 1.0), (20, 2.0), (30, 3.0), (40, 2.5), (1, "50%%d %%% 10^ 2 \\U+00D8\u8F2A"), (50, 30.0), (41, 0.8), (51, 15.0), (7, "NARROW"), (72, 1), (73, 2), (11, 4.0), (21, 5.0),
        (0, "TEXT"), (10, 0.0), (20, 0.0), (40, 1.0), (1, "fit"), (72, 5), (11, 9.0), (21, 1.0),
        (0, "MTEXT"), (10, 7.0), (20, 8.0), (40, 2.0), (41, 60.0), (71, 6), (44, 1.5), (50, 20.0), (3, new string('a', 300)), (1, "{\\H2;b}\\Pc \\\\ \\{d\\}\\~e"),
        (0, "MTEXT"), (10, 7.0), (20, 8.0), (40, 2.0), (71, 1), (1, "back"), (210, 0.0), (220, 0.0), (230, -1.0), (50, 20.0),
        (0, "INSERT"), (66, 1), (2, "B"), (10, 10.0), (20, 0.0), (41, 2.0), (42, 2.0), (50, 90.0), (0, "ATTRIB"), (10, 1.0), (20, 1.0), (40, 1.0), (1, "tag"), (2, "T"), (70, 1), (0, "SEQEND"),
    ];

    [Fact]
    public async Task Heights_come_back_as_they_were()
    {
        await using var talk = new CommandTestSession();
        var (before, after) = await SavedAsync(talk, new DxfText().Header("AC1015", 4).Section("ENTITIES", s_raised).End());

        Assert.Equal(8, before.Entities.Count);
        Assert.Equal(before.Parts.Count, after.Parts.Count);
        Assert.Equal(DrawingSummary.From(before).Length.Total, DrawingSummary.From(after).Length.Total, 1e-9);
        Assert.Equal(DrawingSummary.From(before).Length.PlanTotal, DrawingSummary.From(after).Length.PlanTotal, 1e-9);
        for (var part = 0; part < before.Parts.Count; part++) Assert.Equal(HeightsOf(before, part), HeightsOf(after, part));
    }

    /// <summary>An ARC from 30 to 390 degrees is a point to other programs.</summary>
    [Theory]
    [InlineData("ROTATE", "ALL", "", "0,0", "30")]
    [InlineData("MIRROR", "ALL", "", "0,0", "1,3", "Y")]
    public async Task A_turned_or_mirrored_circle_is_a_circle(params string[] edit)
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllBytesAsync(talk.PathOf("in.dxf"), DxfText.WithEntities((0, "CIRCLE"), (10, 5.0), (20, 0.0), (40, 2.0)).ToAscii());
        await talk.TypeAsync(["OPEN", "in.dxf", .. edit, "SAVEAS", "out.dxf"]);
        var written = await File.ReadAllTextAsync(talk.PathOf("out.dxf"));

        Assert.Contains("\nCIRCLE\n", written, StringComparison.Ordinal);
        Assert.DoesNotContain("\nARC\n", written, StringComparison.Ordinal);
    }

    /// <summary>An ellipse of a millionth of a degree was written as NaN.</summary>
    [Fact]
    public async Task A_sliver_of_an_ellipse_is_written_with_numbers()
    {
        await using var talk = new CommandTestSession();
        var (before, after) = await SavedAsync(talk, DxfText.WithEntities((0, "LINE"), (10, 0.0), (20, 0.0), (11, 40.0), (21, 0.0), (0, "ELLIPSE"), (10, 423.71213738), (20, -73.35906756), (11, 41.4999959), (21, 0.01877599), (40, 0.9819277), (41, 0.0), (42, 1e-8)));

        Assert.DoesNotContain("NaN", await File.ReadAllTextAsync(talk.PathOf("out.dxf")), StringComparison.Ordinal);
        Assert.Equal(2, after.Entities.Count);
        Assert.Equal(DrawingSummary.From(before).Length.Total, DrawingSummary.From(after).Length.Total, 1e-9);
    }

    [Fact]
    public async Task Texts_come_back_as_they_were_placed()
    {
        await using var talk = new CommandTestSession();
        var (before, after) = await SavedAsync(talk, new DxfText().Header("AC1021", 4)
            .Section("TABLES", (0, "STYLE"), (2, "STANDARD"), (70, 0), (3, "txt"), (0, "STYLE"), (2, "NARROW"), (70, 0), (3, "simplex.shx"))
            .Section("BLOCKS", (0, "BLOCK"), (2, "B"), (10, 0.0), (20, 0.0), (0, "TEXT"), (10, 1.0), (20, 0.0), (40, 3.0), (1, "in a block"), (0, "ENDBLK"))
            .Section("ENTITIES", s_texts).End());

        Assert.Equal(6, before.Texts.Count);
        Assert.Equal("50° % 10^2 Ø輪", before.Texts[0].Content);
        Assert.Equal(before.Texts.Select(Shown), after.Texts.Select(Shown));
        Assert.DoesNotContain("DOC0003", talk.Said, StringComparison.Ordinal);
    }

    /// <summary>A height in the string of an MTEXT is in drawing units: it would be wrong after scaling, a paragraph or a relative height is not.</summary>
    [Theory]
    [InlineData("MOVE", @"{\H2;b} \S1/2;", @"{\H2;b} \S1/2;", "5,7")]
    [InlineData("SCALE", @"{\C1;b}\pqc; \S1/2;", @"{\C1;b}\pqc; \S1/2;", "2")]
    [InlineData("SCALE", @"{\H2;b} \S1/2;", "b 1/2", "2")]
    public async Task A_moved_text_keeps_its_formats_and_a_scaled_one_unless_they_have_heights(string edit, string raw, string written, string by)
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllBytesAsync(talk.PathOf("in.dxf"), DxfText.WithEntities((0, "LINE"), (10, 0.0), (20, 0.0), (11, 9.0), (21, 0.0), (0, "MTEXT"), (10, 1.0), (20, 2.0), (40, 3.0), (1, raw), (0, "TEXT"), (10, 1.0), (20, 2.0), (40, 3.0), (71, 4), (1, "%%c")).ToAscii());
        await talk.TypeAsync("OPEN", "in.dxf", edit, "ALL", "", "0,0", by);
        var moved = talk.State.Drawing!.Texts;
        await talk.TypeAsync("SAVEAS", "out.dxf", "OPEN", "out.dxf");
        var texts = talk.State.Drawing!.Texts;

        Assert.Equal((written, "%%c", TextGeneration.UpsideDown), (texts[0].Written.Raw, texts[1].Written.Raw, texts[1].Written.Generation));
        Assert.Equal(moved.Select(text => text.Inserts.Apply(text.Written.Insertion)), texts.Select(text => text.Written.Insertion));
        Assert.Equal(moved.Select(text => text.Written.Height * text.Inserts.YAxis.Length), texts.Select(text => text.Written.Height));
        Assert.True(texts[0].Inserts.IsIdentity);
    }

    [Fact]
    public async Task Points_come_back_as_they_were_placed()
    {
        await using var talk = new CommandTestSession();
        var (before, after) = await SavedAsync(talk, new DxfText().Header("AC1021", 4).Section("ENTITIES", (0, "LINE"), (10, 0.0), (20, 0.0), (11, 1.0), (21, 0.0),
            (0, "POINT"), (8, "NOTES"), (62, 3), (10, 1.5), (20, -2.0), (30, 7.0), (0, "POINT"), (60, 1), (420, 0x102030), (10, 4.0), (20, 5.0)).End());

        Assert.Equal(2, before.Points.Count);
        Assert.Equal(before.Points.Select(point => Placed(before, point)), after.Points.Select(point => Placed(after, point)));
        Assert.DoesNotContain("DOC0003", talk.Said, StringComparison.Ordinal);

        static (PlacedPoint, string) Placed(Drawing drawing, PlacedPoint point) => (point with { Layer = 0, Handle = 0, SourceLine = 0 }, drawing.Layers[point.Layer].Name);
    }

    [Fact]
    public async Task What_a_drawing_does_not_hold_is_counted_before_the_file_is_written()
    {
        await using var talk = new CommandTestSession();
        (int, object)[] point = [(0, "POINT"), (10, 0.0), (20, 0.0)];
        await SavedAsync(talk, new DxfText().Header("AC1015", 4).Section("ENTITIES", [.. s_raised, .. point, .. point, (0, "DIMENSION"), (0, "HATCH"), (91, 0), (0, "BODY")]).End());

        Assert.Contains("DOC0003: Records not written: 3 (1 BODY, 1 DIMENSION, 1 HATCH). A drawing holds curves, texts and points only.", talk.Said, StringComparison.Ordinal);
        Assert.True(talk.Said.IndexOf("DOC0003", StringComparison.Ordinal) < talk.Said.IndexOf("out.dxf written: 8 curves and 0 texts, 2 points", StringComparison.Ordinal), talk.Said);
    }

    /// <summary>SAVEAS gives the drawing another file, which QSAVE writes from then on; the opened file is unchanged.</summary>
    [Fact]
    public async Task QSAVE_writes_the_file_that_was_saved_last()
    {
        await using var talk = new CommandTestSession();
        await SavedAsync(talk, new DxfText().Header("AC1015", 4).Section("ENTITIES", s_raised).End());
        var opened = await File.ReadAllBytesAsync(talk.PathOf("in.dxf"));
        await talk.TypeAsync("OPEN", "in.dxf", "SAVEAS", "other.dxf");
        Assert.Equal(talk.PathOf("other.dxf"), talk.Session.Document.FilePath);
        await talk.TypeAsync("MOVE", "ALL", "", "0,0", "100,0", "QSAVE");
        Assert.Contains("Replace other.dxf?", talk.Session.Prompt.Text, StringComparison.Ordinal);
        await talk.TypeAsync("Y", "SACEPATH", "L", "", "QSAVE");

        Assert.Equal(opened, await File.ReadAllBytesAsync(talk.PathOf("in.dxf")));
        Assert.True(File.Exists(talk.PathOf("other.dxf.engraver.json")));
        Assert.False(File.Exists(talk.PathOf("in.dxf.engraver.json")));
        await talk.TypeAsync("OPEN", "other.dxf");
        Assert.Equal(101.0, talk.State.Drawing!.Parts[0].A);
        await talk.TypeAsync("OPEN", "in.dxf", "MOVE", "ALL", "", "0,0", "1,0", "QSAVE");
        Assert.Contains("Replace in.dxf?", talk.Session.Prompt.Text, StringComparison.Ordinal); // Opened again, it is equal.
        await talk.Session.CancelAsync();
    }

    private static async Task<(Drawing Before, Drawing After)> SavedAsync(CommandTestSession talk, DxfText file)
    {
        await File.WriteAllBytesAsync(talk.PathOf("in.dxf"), file.ToAscii());
        await talk.TypeAsync("OPEN", "in.dxf");
        var before = talk.State.Drawing!;
        await talk.TypeAsync("SAVEAS", "out.dxf", "OPEN", "out.dxf");
        return (before, talk.State.Drawing!);
    }

    private static double[] HeightsOf(Drawing drawing, int index)
    {
        var part = drawing.Parts[index];
        if (!part.IsFreeCurve) return part.Kind == Core.Geometry.SegmentKind.Line ? [part.C, part.F] : [part.C];
        return [.. drawing.Curves[part.CurveIndex].Spans.ToArray().SelectMany(span => Enumerable.Range(0, span.Degree + 1).Select(i => Math.Round(span.Z(i), 9)))];
    }

    private static string Shown(PlacedText text) => FormattableString.Invariant(
        $"{text.Content}|{text.Position.X:0.######} {text.Position.Y:0.######} {text.Position.Z}|{text.End?.X} {text.End?.Y}|{text.Height:0.######} {text.Rotation.Degrees:0.######} {text.WidthFactor:0.######} {text.Oblique.Degrees}|{text.Mirrored} {text.FrameWidth} {text.LineSpacing} {text.Column} {text.Row}|{text.Style} {text.Font} {text.Layer} {text.Hidden}");
}
