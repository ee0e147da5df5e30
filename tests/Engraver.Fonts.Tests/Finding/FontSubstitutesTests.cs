using System.Text;
using Engraver.Fonts.Finding;
using Engraver.Fonts.Strokes;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests.Finding;

public sealed class FontSubstitutesTests : IDisposable
{
    private readonly FontFolderFixture _folders = new();

    public void Dispose() => _folders.Dispose();

    [Theory]
    [InlineData("txt.shx", false)]
    [InlineData("txt", false)]
    [InlineData("SIMPLEX.SHX", false)]
    [InlineData("romans", false)]
    [InlineData("isocp3.shx", false)]
    [InlineData("gdt.shx", false)]
    [InlineData("c:\\acad\\fonts\\romand.shx", true)]
    [InlineData("italict", true)]
    [InlineData("gothice.shx", true)]
    public void Stroke_fonts_of_AutoCAD_are_replaced_by_those_of_the_program(string file, bool isDouble)
    {
        var found = Find(new FontRequest(file, "", false, false));

        Assert.Same(isDouble ? DoubleStrokeFont.Engraver : StrokeFont.Engraver, found.Font);
        Assert.Equal((FontMatch.ByTable, FontTrouble.NotFound), (found.Match, found.Trouble));
    }

    [Fact]
    public void A_stroke_font_that_the_user_has_is_not_replaced()
    {
        var path = Write("drawing/txt.shx", 4);

        foreach (var file in (string[])["txt", "TXT.SHX"]) Assert.Equal((FontMatch.Exact, path), Find(new FontRequest(file, "", false, false)) is var found ? (found.Match, found.Path) : default);
    }

    [Fact]
    public void LFF_and_JHF_fonts_are_found_by_their_whole_names_only()
    {
        var lff = _folders.Write("drawing/plate.lff", "[0041]\n0,0;1,1\n"u8.ToArray());
        var jhf = _folders.Write("drawing/plate.jhf", "12345  1JZ\n"u8.ToArray());

        Assert.Equal((FontMatch.Exact, lff), Find(new FontRequest("Plate.LFF", "", false, false)) is var one ? (one.Match, one.Path) : default);
        Assert.Equal((FontMatch.Exact, jhf), Find(new FontRequest("plate.jhf", "", false, false)) is var two ? (two.Match, two.Path) : default);
        Assert.Equal(FontTrouble.NotFound, Find(new FontRequest("plate", "", false, false)).Trouble);
    }

    [Theory]
    [InlineData("big.shx", "AutoCAD-86 bigfont 1.0\r\n\u001A")]
    [InlineData("big.lff", "nothing")]
    [InlineData("big.jhf", "nothing")]
    public void A_stroke_font_that_cannot_be_read_is_broken(string file, string content)
    {
        _folders.Write("drawing/" + file, Encoding.Latin1.GetBytes(content));
        var found = Find(new FontRequest(file, "", false, false));

        Assert.Equal((FontMatch.Substitute, FontTrouble.Broken), (found.Match, found.Trouble));
    }

    [Theory]
    [InlineData("Arial", "", "Liberation Sans")]
    [InlineData("Arial", "arial.ttf", "Liberation Sans")]
    [InlineData("Calibri", "", "Carlito")]
    [InlineData("Cambria", "cambria.ttc", "Caladea")]
    [InlineData("Times New Roman", "", "Liberation Serif")]
    [InlineData("courier new", "", "Liberation Mono")]
    public void A_family_that_is_missing_is_replaced_by_one_with_the_same_widths(string family, string file, string substitute)
    {
        foreach (var name in (string[])["Carlito", "Caladea", "Liberation Sans", "Liberation Serif", "Liberation Mono"]) _folders.Write($"fonts/{name}.ttf", FontBuilder.TrueType(name, 4, 'A'));
        var found = Find(new FontRequest(file, family, false, false));

        Assert.Equal((FontMatch.ByTable, FontTrouble.NotFound, substitute), (found.Match, found.Trouble, found.Font.Name));
    }

    [Fact]
    public void The_file_of_a_style_is_replaced_by_the_file_of_the_same_style()
    {
        var bold = _folders.Write("fonts/LiberationSans-Bold.ttf", FontBuilder.TrueType("Liberation Sans", 4, 'A'));
        _folders.Write("fonts/LiberationSans-Regular.ttf", FontBuilder.TrueType("Liberation Sans", 4, 'A'));

        Assert.Equal(bold, Find(new FontRequest("arialbd.ttf", "", false, false)).Path);
    }

    [Fact]
    public void A_family_with_no_substitute_that_is_installed_is_the_stroke_font() =>
        Assert.Equal((FontMatch.Substitute, FontTrouble.NotFound, "Engraver"), Find(new FontRequest("", "Arial", true, false)) is var found ? (found.Match, found.Trouble, found.Font.Name) : default);

    [Fact]
    public void The_users_own_table_replaces_fonts_that_are_installed_too()
    {
        Write("fonts/txt.shx", 4);
        var other = Write("fonts/other.shx", 5);
        WriteTable("fonts", "# my fonts\n\n; another comment\ntxt.shx ; other.shx\nromand;engraver\n");

        Assert.Equal((FontMatch.ByTable, FontTrouble.None, other), Find(new FontRequest("TXT", "", false, false)) is var found ? (found.Match, found.Trouble, found.Path) : default);
        Assert.Same(StrokeFont.Engraver, Find(new FontRequest("romand.shx", "", false, false)).Font);
        Assert.Same(DoubleStrokeFont.Engraver, Find(new FontRequest("romant.shx", "", false, false)).Font);
    }

    [Fact]
    public void The_table_beside_the_drawing_comes_first()
    {
        WriteTable("drawing", "plate;engraver-double\n");
        WriteTable("fonts", "plate;engraver\n");

        Assert.Same(DoubleStrokeFont.Engraver, Find(new FontRequest("plate", "", false, false)).Font);
    }

    [Fact]
    public void A_substitute_of_the_own_table_that_is_missing_leaves_the_font_as_it_is()
    {
        var path = Write("fonts/txt.shx", 4);
        WriteTable("fonts", "txt;nowhere.shx\n");

        Assert.Equal((FontMatch.Exact, path), Find(new FontRequest("txt", "", false, false)) is var found ? (found.Match, found.Path) : default);
    }

    [Fact]
    public void Lines_that_cannot_be_read_are_reported()
    {
        WriteTable("drawing", "txt\na;b;c\n;comment\nx;\n;y\ngood;engraver\n");
        var substitutes = FontSubstitutes.In(Folders);

        Assert.Equal([(1, "txt"), (2, "a;b;c"), (4, "x;")], substitutes.Faults.Select(fault => (fault.Line, fault.Text)));
        Assert.All(substitutes.Faults, fault => Assert.Equal(_folders.Path("drawing/fonts.fmp"), fault.Path));
    }

    [Fact]
    public void A_table_that_cannot_be_opened_is_reported()
    {
        WriteTable("drawing", "txt;engraver\n");
        using var _ = new FileStream(_folders.Path("drawing/fonts.fmp"), FileMode.Open, FileAccess.ReadWrite, FileShare.None);

        Assert.Equal([0], FontSubstitutes.In(Folders).Faults.Select(fault => fault.Line));
    }

    [Fact]
    public void Each_line_of_the_programs_table_can_be_used()
    {
        var lines = File.ReadAllLines(Path.Combine(RepositoryFolder.Root, "src/Engraver.Fonts/Finding/Data/substitutes.fmp")).Where(line => line.Length > 0 && line[0] != '#').ToList();

        Assert.True(lines.Count > 150);
        Assert.DoesNotContain(lines, line => line.Split(';') is not [{ Length: > 0 }, { Length: > 0 }]);
        Assert.Equal(lines.Distinct(StringComparer.OrdinalIgnoreCase), lines);
    }

    private string[] Folders => [_folders.Folder("drawing"), _folders.Folder("fonts")];

    private string Write(string name, int height) => _folders.Write(name, new StrokeFiles.ShxBuilder("unifont 1.0", above: height).With('A', 0x10).Build());

    private void WriteTable(string folder, string text) => _folders.Write(folder + "/fonts.fmp", Encoding.UTF8.GetBytes(text));

    private FoundFont Find(FontRequest request) => new FontLibrary(Folders, FontSubstitutes.In(Folders)).Find(request);
}
