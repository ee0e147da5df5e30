using System.Text;
using Engraver.Fonts.StrokeFiles;

namespace Engraver.Fonts.Tests.StrokeFiles;

/// <summary>Fonts with changed, missing and added bytes are read or end with a <see cref="BrokenFontException"/>. A glyph has at most the
/// pieces of the limit.</summary>
public class DamagedStrokeFontTests
{
    private const int Rounds = 2000;

    private static readonly int[] s_characters = [.. Enumerable.Range(0x20, 0xE0)];

    [Theory]
    [InlineData("shapes 1.0")]
    [InlineData("shapes 1.1")]
    [InlineData("unifont 1.0")]
    public void A_shape_font_is_read_or_refused(string kind)
    {
        var font = new ShxBuilder(kind).With(10, 2, 8, 0, 0xF0);
        var number = (int)'A';
        foreach (object[] row in ShxFontTests.Codes) font.With(number++, (byte[])row[1]);
        font.With(0xA0, [.. Enumerable.Range('A', 20).SelectMany(shape => kind[0] == 'u' ? (byte[])[7, 0, (byte)shape] : [7, (byte)shape])]);

        Damage(font.Build(), data => ShxFont.Read(data, "file"));
    }

    [Fact]
    public void An_LFF_font_is_read_or_refused() =>
        Damage(Encoding.UTF8.GetBytes("# Format: LibreCAD Font 1\n# LetterSpacing: 3\n\n[0041] A\n0,0;3,9;6,0\n1.5,3;4.5,3\n\n[0042] B\nC0041\n0,2;4,2,A1;0,2,A1\n\n[0043] C\nC0042\nC0041\n"), data => LffFont.Read(data, "file"));

    [Fact]
    public void A_Hershey_font_is_read_or_refused() =>
        Damage(Encoding.ASCII.GetBytes("12345  1JZ\n12345  9MWRFR[ RRYQZR[SZRY\n 2501  9I[RFJ[ RRFZ\n[ RMTWT\n"), data => JhfFont.Read(data, "file"));

    private static void Damage(byte[] good, Func<byte[], ITextFont> read)
    {
        var random = new Random(35);
        int whole = 0, refused = 0;
        for (var round = 0; round < Rounds; round++)
        {
            var bad = good.ToList();
            for (var i = 0; i <= round % 6; i++)
            {
                var at = random.Next(bad.Count);
                if (random.Next(8) == 0) bad.RemoveAt(at);
                else if (random.Next(8) == 0) bad.Insert(at, (byte)random.Next(256));
                else bad[at] = (byte)random.Next(256);
            }

            if (round % 4 == 0) bad = bad[..random.Next(bad.Count / 2, bad.Count)];
            if (IsReadable([.. bad], read)) whole++;
            else refused++;
        }

        Assert.True(whole > 0 && refused > 0, $"{whole} read, {refused} refused");
    }

    private static bool IsReadable(byte[] data, Func<byte[], ITextFont> read)
    {
        ITextFont font;
        try
        {
            font = read(data);
        }
        catch (BrokenFontException)
        {
            return false;
        }

        var isWhole = true;
        foreach (var code in s_characters)
        {
            try
            {
                if (font.GlyphOf(code) is { } glyph) Assert.Empty(StrokeFontCheck.Faults(glyph));
            }
            catch (BrokenFontException)
            {
                isWhole = false;
            }
        }

        return isWhole;
    }
}
