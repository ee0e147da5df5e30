using Engraver.Fonts.OpenType;
using Engraver.TestKit;

namespace Engraver.Fonts.Tests.OpenType;

/// <summary>Fonts with changed bytes and cut files end with <see cref="BrokenFontException"/> or are read; nothing else is thrown, and nothing runs without
/// end.</summary>
public class DamagedFontTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_small_font_is_read_or_refused(bool isCff)
    {
        byte[] kern = [.. FontBuilder.U16(0), .. FontBuilder.U16(1), .. FontBuilder.U16(0), .. FontBuilder.U16(20), .. FontBuilder.U16(1), .. FontBuilder.U16(1), .. new byte[6], .. FontBuilder.U16(1), .. FontBuilder.U16(1), .. FontBuilder.U16(-30)];
        var font = isCff ? FontBuilder.Cff("Lines", [239, 189, 21, 247, 192, 6, 247, 92, 7, 14]) : FontBuilder.TrueType("Square", 4, 'A');

        Damage(font.With("kern", kern).Build(), rounds: 4000, ['A', 'H']);
    }

    [InstalledFontFact]
    public void A_real_font_is_read_or_refused() => Damage(File.ReadAllBytes(InstalledFontFactAttribute.TrueType), rounds: TestExtent.IsFull ? 2000 : 100, [.. Enumerable.Range(0x20, 0x160)]);

    /// <summary>Changes fall on the directory and the heads of tables more often than on the rest, because most bytes of a font are outlines.</summary>
    private static void Damage(byte[] good, int rounds, int[] characters)
    {
        var random = new Random(7);
        int read = 0, refused = 0;
        for (var round = 0; round < rounds; round++)
        {
            var bad = good.ToArray();
            for (var i = 0; i <= round % 8; i++)
                bad[random.Next(i % 2 == 0 ? bad.Length : Math.Min(bad.Length, 600))] = (byte)random.Next(256);
            var length = round % 3 == 0 ? random.Next(bad.Length) : bad.Length;
            if (IsReadable(bad.AsMemory(0, length), characters)) read++;
            else refused++;
        }

        Assert.True(read > 0 && refused > 0, $"{read} read, {refused} refused");
    }

    private static bool IsReadable(ReadOnlyMemory<byte> file, int[] characters)
    {
        try
        {
            var font = new OutlineFont(new MemoryFontSource(file));
            for (var i = 0; i < characters.Length; i++)
            {
                font.GlyphOf(characters[i]);
                font.KerningOf(characters[0], characters[i]);
            }
            return true;
        }
        catch (BrokenFontException)
        {
            return false;
        }
    }
}
