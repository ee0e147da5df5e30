using Avalonia.Media;
using Engraver.SoftwarePlatform.Text;
using Engraver.TestKit;

namespace Engraver.SoftwarePlatform.Tests.Text;

public sealed class FontManagerTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("fonts");

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public void The_font_of_a_character_is_one_that_has_it()
    {
        Write("latin.ttf", FontBuilder.TrueType("Latin", 4, 'A').Build());
        Write("deeper/han.ttc", FontBuilder.Collection(FontBuilder.TrueType("Other", 4, 'B'), FontBuilder.TrueType("Han", 12, 0x4E2D, 0x20000)));
        var manager = Manager();

        Assert.Equal("Han", Match(manager, 0x4E2D));
        Assert.Equal("Han", Match(manager, 0x20000));
        Assert.Equal("Latin", Match(manager, 'A'));
        Assert.Null(Match(manager, 0x1F600));
    }

    [Fact]
    public void Families_are_found_by_name_and_made_bold_or_slanted_where_they_lack_it()
    {
        Write("square.ttf", FontBuilder.TrueType("Square", 4, 'A').Build());
        var manager = Manager();

        Assert.Equal(["Square"], manager.GetInstalledFontFamilyNames());
        Assert.True(manager.TryCreateGlyphTypeface("square", FontStyle.Italic, FontWeight.Bold, FontStretch.Normal, out var typeface));
        Assert.Equal(FontSimulations.Bold | FontSimulations.Oblique, typeface.FontSimulations);
        Assert.True(manager.TryCreateGlyphTypeface("Square", FontStyle.Normal, FontWeight.Normal, FontStretch.Normal, out var plain));
        Assert.Equal(FontSimulations.None, plain.FontSimulations);
        Assert.False(manager.TryCreateGlyphTypeface("Round", FontStyle.Normal, FontWeight.Normal, FontStretch.Normal, out _));
        Assert.True(manager.TryGetFamilyTypefaces("Square", out var faces));
        Assert.Single(faces);
    }

    [Fact]
    public void Broken_files_and_other_files_are_passed_over()
    {
        Write("good.ttf", FontBuilder.TrueType("Good", 4, 'A').Build());
        Write("empty.ttf", []);
        Write("text.otf", "This is no font."u8.ToArray());
        Write("cut.ttc", FontBuilder.Collection(FontBuilder.TrueType("Cut", 4, 'A'))[..60]);
        Write("bare.ttf", FontBuilder.TrueType("Bare", 4, 'A').Without("glyf").Build());
        Write("readme.txt", [1, 2, 3]);

        Assert.Equal(["Good"], Manager().GetInstalledFontFamilyNames());
    }

    [Fact]
    public void A_folder_that_does_not_exist_is_no_fault() =>
        Assert.Empty(new SoftwareFontManager([Path.Combine(_folder.FullName, "nowhere")]).GetInstalledFontFamilyNames());

    [Fact]
    public void The_default_family_comes_with_the_program() => Assert.Equal("fonts:Inter#Inter", Manager().GetDefaultFontFamilyName());

    private SoftwareFontManager Manager() => new([_folder.FullName]);

    private static string? Match(SoftwareFontManager manager, int character) =>
        manager.TryMatchCharacter(character, FontStyle.Normal, FontWeight.Normal, FontStretch.Normal, null, null, out var typeface) ? typeface.FamilyName : null;

    private void Write(string name, byte[] data)
    {
        var path = Path.Combine(_folder.FullName, name);
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllBytes(path, data);
    }
}
