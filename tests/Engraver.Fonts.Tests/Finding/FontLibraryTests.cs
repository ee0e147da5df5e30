using System.Buffers.Binary;
using System.Security.Cryptography;
using Engraver.Fonts.Finding;
using Engraver.Fonts.OpenType;
using Engraver.Fonts.Strokes;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests.Finding;

public sealed class FontLibraryTests : IDisposable
{
    private readonly FontFolderFixture _folders = new();

    public void Dispose() => _folders.Dispose();

    [Theory]
    [InlineData("engraver")]
    [InlineData("Engraver.SHX")]
    [InlineData("C:\\fonts\\engraver.shx")]
    public void The_font_of_the_program_is_found_by_its_name(string file)
    {
        var found = Find(File(file));

        Assert.Same(StrokeFont.Engraver, found.Font);
        Assert.Equal((FontMatch.Exact, FontTrouble.None, null), (found.Match, found.Trouble, found.Path));
        Assert.Equal(64, found.Sha256.Length);
    }

    [Fact]
    public void Its_double_stroke_weight_has_a_name_of_its_own()
    {
        var found = Find(File("engraver-double"));

        Assert.Same(DoubleStrokeFont.Engraver, found.Font);
        Assert.Equal((FontMatch.Exact, FontTrouble.None), (found.Match, found.Trouble));
        Assert.NotEqual(Find(File("engraver")).Sha256, found.Sha256);
    }

    [Theory]
    [InlineData("plate.ttf")]
    [InlineData("PLATE.TTF")]
    [InlineData("plate")]
    [InlineData("d:/work/Plate.ttf")]
    public void A_file_is_found_by_its_name_in_any_case(string file)
    {
        var path = _folders.Write("drawing/Plate.ttf", Square("Any"));
        var found = Find(File(file));

        Assert.Equal((FontMatch.Exact, FontTrouble.None, path, "Any"), (found.Match, found.Trouble, found.Path, found.Font.Name));
        Assert.Equal(Convert.ToHexStringLower(SHA256.HashData(System.IO.File.ReadAllBytes(path))), found.Sha256);
    }

    [Fact]
    public void The_folder_of_the_drawing_is_searched_before_the_others()
    {
        var expected = _folders.Write("drawing/plate.ttf", Square("First"));
        _folders.Write("fonts/plate.ttf", Square("Second"));

        Assert.Equal(expected, Find(File("plate.ttf")).Path);
    }

    [Fact]
    public void A_folder_inside_the_folder_of_a_drawing_is_not_searched()
    {
        _folders.Write("drawing/old/plate.ttf", Square("Plate"));

        Assert.Equal(FontTrouble.NotFound, Find(File("plate.ttf")).Trouble);
        Assert.Equal(FontTrouble.NotFound, Find(Family("Plate")).Trouble);
    }

    [Theory]
    [InlineData(false, false, "regular.ttf")]
    [InlineData(true, false, "bold.ttf")]
    [InlineData(false, true, "italic.ttf")]
    public void A_family_is_found_with_its_style(bool isBold, bool isItalic, string file)
    {
        WriteFamily();
        var found = Find(new FontRequest("", "SQUARE", isBold, isItalic));

        Assert.Equal((FontMatch.Exact, FontTrouble.None, file), (found.Match, found.Trouble, Path.GetFileName(found.Path)));
    }

    [Fact]
    public void A_family_without_the_style_gives_its_nearest_face_as_a_substitute()
    {
        WriteFamily();
        var found = Find(new FontRequest("", "Square", true, true));

        Assert.Equal((FontMatch.Substitute, FontTrouble.NotFound, "italic.ttf"), (found.Match, found.Trouble, Path.GetFileName(found.Path)));
    }

    [Fact]
    public void A_family_that_is_not_the_file_is_found_if_the_file_is_not_there()
    {
        WriteFamily();

        Assert.Equal("bold.ttf", Path.GetFileName(Find(new FontRequest("squareb.ttf", "Square", true, false)).Path));
    }

    [Fact]
    public void The_face_of_a_collection_is_that_of_the_family()
    {
        _folders.Write("drawing/two.ttc", FontBuilder.Collection(Square("First"), Square("Second")));

        Assert.Equal("Second", Find(Family("Second")).Font.Name);
        Assert.Equal("Second", Find(new FontRequest("two.ttc", "Second", false, false)).Font.Name);
        Assert.Equal("First", Find(File("two.ttc")).Font.Name);
    }

    [Fact]
    public void A_broken_file_is_reported_and_replaced()
    {
        _folders.Write("drawing/plate.ttf", [1, 2, 3]);
        var found = Find(File("plate.ttf"));

        Assert.Equal((FontMatch.Substitute, FontTrouble.Broken, null), (found.Match, found.Trouble, found.Path));
        Assert.Same(StrokeFont.Engraver, found.Font);
    }

    [Fact]
    public void A_good_file_behind_a_broken_one_is_a_substitute()
    {
        _folders.Write("drawing/plate.ttf", [1, 2, 3]);
        var good = _folders.Write("fonts/plate.ttf", Square("Plate"));

        Assert.Equal((FontMatch.Substitute, FontTrouble.Broken, good), Find(File("plate.ttf")) is var found ? (found.Match, found.Trouble, found.Path!) : default);
    }

    [Fact]
    public void A_font_that_is_nowhere_is_the_stroke_font()
    {
        var found = Find(File("nowhere.shx"));

        Assert.Same(StrokeFont.Engraver, found.Font);
        Assert.Equal((FontMatch.Substitute, FontTrouble.NotFound), (found.Match, found.Trouble));
        Assert.Same(StrokeFont.Engraver, Find(File("")).Font);
    }

    [Fact]
    public void A_found_font_is_kept()
    {
        var path = _folders.Write("drawing/plate.ttf", Square("Plate"));
        var library = Library();
        var first = library.Find(File("plate.ttf"));
        System.IO.File.Delete(path);

        Assert.Same(first, library.Find(File("plate.ttf")));
        Assert.Same(first.Font, library.Find(File("PLATE.ttf")).Font);
    }

    [Fact]
    public void Names_of_families_are_not_read_before_a_family_is_searched()
    {
        var path = _folders.Write("fonts/a.ttf", Square("First"));
        _folders.Write("fonts/b.ttf", Square("Other"));
        var library = Library();
        foreach (var file in (string[])["txt.shx", "romans", "b.ttf", "nowhere.ttf"]) library.Find(File(file));
        _folders.Write("fonts/a.ttf", Square("Later"));

        Assert.Equal((FontMatch.Exact, path), library.Find(Family("Later")) is var found ? (found.Match, found.Path) : default);
        Assert.Equal(FontTrouble.NotFound, library.Find(Family("First")).Trouble);
    }

    [Fact]
    public void A_bold_request_whose_file_is_not_bold_is_the_bold_face_of_the_family()
    {
        WriteFamily();

        Assert.Equal("bold.ttf", Path.GetFileName(Find(new FontRequest("regular.ttf", "Square", true, false)).Path));
        Assert.Equal("bold.ttf", Path.GetFileName(Find(new FontRequest("bold.ttf", "Square", false, false)).Path));
        Assert.Equal((FontMatch.Substitute, "regular.ttf"), Find(new FontRequest("regular.ttf", "", true, false)) is var found ? (found.Match, Path.GetFileName(found.Path)) : default);
    }

    [Fact]
    public void Searches_of_several_threads_give_the_same_font()
    {
        WriteFamily();
        var library = Library();
        var fonts = new FoundFont[64];
        Parallel.For(0, fonts.Length, i => fonts[i] = library.Find(i % 2 == 0 ? Family("Square") : File("bold.ttf")));

        Assert.Equal(2, fonts.Distinct(ReferenceEqualityComparer.Instance).Count());
    }

    [Fact]
    public void Folders_of_each_system_are_known()
    {
        Assert.Contains(FontFolders.Windows, folder => folder.EndsWith(Path.Combine("Microsoft", "Windows", "Fonts"), StringComparison.Ordinal));
        Assert.Contains("/Library/Fonts", FontFolders.MacOS);
        Assert.Contains("/usr/share/fonts", FontFolders.Linux);
        Assert.DoesNotContain("", FontFolders.Standard);
    }

    private static FontRequest File(string name) => new(name, "", false, false);

    private static FontRequest Family(string name) => new("", name, false, false);

    private static FontBuilder Square(string family) => FontBuilder.TrueType(family, 4, 'A');

    private static byte[] Style(int weight, int selection)
    {
        var table = new byte[96];
        foreach (var (offset, value) in ((int, int)[])[(0, 4), (4, weight), (6, 5), (62, selection), (68, 700), (70, -300)]) BinaryPrimitives.WriteInt16BigEndian(table.AsSpan(offset), (short)value);
        return table;
    }

    private void WriteFamily()
    {
        _folders.Write("fonts/bold.ttf", Square("Square").With("OS/2", Style(700, 0)));
        _folders.Write("fonts/italic.ttf", Square("Square").With("OS/2", Style(400, 1)));
        _folders.Write("fonts/light.ttf", Square("Square").With("OS/2", Style(300, 0)));
        _folders.Write("fonts/regular.ttf", Square("Square").With("OS/2", Style(400, 0)));
    }

    private FontLibrary Library() => new([_folders.Folder("drawing"), _folders.Folder("fonts")], FontSubstitutes.Standard);

    private FoundFont Find(FontRequest request) => Library().Find(request);
}
