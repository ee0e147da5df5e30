using System.Globalization;
using Engraver.Fonts.Finding;
using Engraver.Fonts.StrokeFiles;

namespace Engraver.Fonts.Tests.StrokeFiles;

/// <summary>Every font of LibreCAD (Debian: librecad-data) and every Hershey font (hershey-fonts-data), where they are installed.</summary>
public class InstalledStrokeFontTests
{
    /// <summary>Characters of these fonts with vertices that are not two numbers.</summary>
    private static readonly string[] s_broken = ["unicode.lff 00A3", "unicode.lff FF0C"];

    [InstalledStrokeFontsFact]
    public void Every_font_of_LibreCAD_opens_and_its_characters_are_strokes()
    {
        var faults = new List<string>();
        int fonts = 0, glyphs = 0;
        foreach (var path in Directory.EnumerateFiles(InstalledStrokeFontsFactAttribute.LibreCadFolder, "*.lff").Order(StringComparer.Ordinal))
        {
            var font = LffFont.Read(File.ReadAllBytes(path), "file");
            fonts++;
            glyphs += Check(path, font, font.CodePoints, faults);
        }

        Assert.True(fonts >= 40 && glyphs > 30_000, $"{fonts} fonts, {glyphs} glyphs");
        Assert.Equal(s_broken, faults);
    }

    [InstalledStrokeFontsFact]
    public void Every_Hershey_font_opens_and_its_characters_are_strokes()
    {
        var faults = new List<string>();
        int fonts = 0, glyphs = 0;
        foreach (var path in Directory.EnumerateFiles(InstalledStrokeFontsFactAttribute.HersheyFolder, "*.jhf").Order(StringComparer.Ordinal))
        {
            var font = JhfFont.Read(File.ReadAllBytes(path), "file");
            fonts++;
            glyphs += Check(path, font, font.CodePoints, faults);
        }

        Assert.True(fonts >= 30 && glyphs > 3000, $"{fonts} fonts, {glyphs} glyphs");
        Assert.Empty(faults);
    }

    [InstalledStrokeFontsFact]
    public void A_font_of_LibreCAD_is_found_by_its_whole_name()
    {
        var library = new FontLibrary([InstalledStrokeFontsFactAttribute.LibreCadFolder], FontSubstitutes.Standard);

        Assert.Equal((FontMatch.Exact, "Roman Simplex"), library.Find(new FontRequest("romans.lff", "", false, false)) is var found ? (found.Match, found.Font.Name) : default);
        Assert.Equal((FontMatch.ByTable, "Engraver"), library.Find(new FontRequest("romans", "", false, false)) is var other ? (other.Match, other.Font.Name) : default);
    }

    private static int Check(string path, ITextFont font, IEnumerable<int> codePoints, List<string> faults)
    {
        var count = 0;
        foreach (var code in codePoints)
        {
            count++;
            var name = string.Create(CultureInfo.InvariantCulture, $"{Path.GetFileName(path)} {code:X4}");
            try
            {
                faults.AddRange(StrokeFontCheck.Faults(font.GlyphOf(code)!).Select(fault => $"{name} {fault}"));
            }
            catch (BrokenFontException)
            {
                faults.Add(name);
            }
        }

        return count;
    }
}
