using System.Buffers.Binary;
using System.Text;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>The outline letters as a TrueType font, for texts of the samples (OpenType specification, "Font Tables"). Arcs become quadratic curves.</summary>
internal static class OutlineFontFile
{
    public const string FileName = "plate-letters.ttf";

    private const string Family = "Plate Letters";
    private const int UnitsPerLetterUnit = 1000;
    private const int UnitsPerEm = 14_000;
    private const int CapHeight = 10 * UnitsPerLetterUnit;
    private const int Descent = 2_000;
    private const double LetterGap = 1.5;
    private const double WordGap = 4;

    /// <summary>Largest turn of one quadratic curve: its distance from the arc is below 0.02 percent of the radius.</summary>
    private const double LargestTurn = 15;
    private const byte OnCurve = 1;

    public static byte[] Write()
    {
        IReadOnlyList<(char Character, int Advance, byte[] Data)> glyphs =
        [
            ('\0', AdvanceOf(WordGap), []),
            (' ', AdvanceOf(WordGap), []),
            .. OutlineGlyphs.All.OrderBy(glyph => glyph.Key).Select(glyph => (glyph.Key, AdvanceOf(glyph.Value.Width + LetterGap), GlyphOf(glyph.Value))),
        ];
        return Assemble(new SortedDictionary<string, byte[]>(StringComparer.Ordinal)
        {
            ["OS/2"] = [.. U16(4), .. U16(7_000), .. U16(400), .. U16(5), .. new byte[54], .. U16(0x40), .. U16(' '), .. U16('N'), .. U16(CapHeight), .. U16(-Descent), .. U16(0), .. U16(CapHeight), .. U16(Descent), .. new byte[10], .. U16(CapHeight), .. new byte[6]],
            ["cmap"] = CharacterMap([.. glyphs.Select(glyph => glyph.Character)]),
            ["glyf"] = [.. glyphs.SelectMany(glyph => glyph.Data)],
            ["head"] = [.. U32(0x10000), .. U32(0x10000), .. U32(0), .. U32(0x5F0F3CF5), .. U16(0), .. U16(UnitsPerEm), .. new byte[16], .. U16(0), .. U16(0), .. U16(8_000), .. U16(CapHeight), .. U16(0), .. U16(8), .. U16(2), .. U16(1), .. U16(0)],
            ["hhea"] = [.. U32(0x10000), .. U16(CapHeight), .. U16(-Descent), .. U16(0), .. U16(9_000), .. new byte[22], .. U16(glyphs.Count)],
            ["hmtx"] = [.. glyphs.SelectMany(glyph => (byte[])[.. U16(glyph.Advance), .. glyph.Data.Length > 0 ? glyph.Data[2..4] : U16(0)])],
            ["loca"] = [.. Offsets(glyphs.Select(glyph => glyph.Data.Length)).SelectMany(offset => U32(offset))],
            ["maxp"] = [.. U32(0x10000), .. U16(glyphs.Count), .. U16(200), .. U16(4), .. new byte[22]],
            ["name"] = Names(),
            ["post"] = [.. U32(0x30000), .. new byte[28]],
        });
    }

    private static int AdvanceOf(double width) => Units(width);

    private static int Units(double length) => (int)Math.Round(length * UnitsPerLetterUnit);

    /// <summary>Outer contours run clockwise in a TrueType font; the letters are drawn counter-clockwise.</summary>
    private static byte[] GlyphOf(OutlineGlyph letter)
    {
        var contours = letter.Contours.Select(contour => PointsOf(contour).Reverse().ToList()).ToList();
        var points = contours.SelectMany(contour => contour).ToList();
        byte[] box = [.. U16(points.Min(point => point.X)), .. U16(points.Min(point => point.Y)), .. U16(points.Max(point => point.X)), .. U16(points.Max(point => point.Y))];
        var ends = contours.Select((_, index) => contours.Take(index + 1).Sum(contour => contour.Count) - 1);
        byte[] data =
        [
            .. U16(contours.Count), .. box, .. ends.SelectMany(U16), .. U16(0), .. points.Select(point => point.OnCurve ? OnCurve : (byte)0),
            .. Steps(points.Select(point => point.X)), .. Steps(points.Select(point => point.Y)),
        ];
        return [.. data, .. new byte[(4 - (data.Length % 4)) % 4]];
    }

    /// <summary>The points of the font: those of each arc are on its circle, the control points where the tangents of neighbours meet.</summary>
    private static IEnumerable<(int X, int Y, bool OnCurve)> PointsOf(Contour contour)
    {
        for (var i = 0; i < contour.Vertices.Count; i++)
        {
            var (from, to) = (contour.Vertices[i], contour.Vertices[(i + 1) % contour.Vertices.Count].At);
            yield return (Units(from.At.X), Units(from.At.Y), true);
            if (from.Bulge == 0)
            {
                continue;
            }

            var sweep = 4 * Math.Atan(from.Bulge);
            var chord = to - from.At;
            var centre = from.At + (chord * 0.5) + (chord.Left * (0.5 / Math.Tan(sweep / 2)));
            var count = (int)Math.Ceiling(Math.Abs(double.RadiansToDegrees(sweep)) / LargestTurn);
            var (start, turn) = (from.At - centre, double.RadiansToDegrees(sweep) / count);
            for (var piece = 0; piece < count; piece++)
            {
                var control = centre + (start.Rotated((piece + 0.5) * turn) * (1 / Math.Cos(double.DegreesToRadians(turn / 2))));
                yield return (Units(control.X), Units(control.Y), false);
                if (piece == count - 1)
                {
                    continue;
                }

                var on = centre + start.Rotated((piece + 1) * turn);
                yield return (Units(on.X), Units(on.Y), true);
            }
        }
    }

    private static IEnumerable<byte> Steps(IEnumerable<int> values)
    {
        var last = 0;
        foreach (var value in values)
        {
            foreach (var part in U16(value - last))
            {
                yield return part;
            }

            last = value;
        }
    }

    private static IEnumerable<int> Offsets(IEnumerable<int> lengths)
    {
        var at = 0;
        yield return at;
        foreach (var length in lengths)
        {
            yield return at += length;
        }
    }

    /// <summary>One group for each character, format 12.</summary>
    private static byte[] CharacterMap(IReadOnlyList<char> characters)
    {
        var groups = characters.Skip(1).SelectMany((character, index) => (byte[])[.. U32(character), .. U32(character), .. U32(index + 1)]).ToList();
        return [.. U16(0), .. U16(1), .. U16(3), .. U16(10), .. U32(12), .. U16(12), .. U16(0), .. U32(16 + groups.Count), .. U32(0), .. U32(characters.Count - 1), .. groups];
    }

    private static byte[] Names()
    {
        (int Id, string Text)[] names = [(1, Family), (2, "Regular"), (4, Family), (6, Family.Replace(" ", "", StringComparison.Ordinal))];
        var (records, texts) = (new List<byte>(), new List<byte>());
        foreach (var (id, text) in names)
        {
            var bytes = Encoding.BigEndianUnicode.GetBytes(text);
            records.AddRange([.. U16(3), .. U16(1), .. U16(0x409), .. U16(id), .. U16(bytes.Length), .. U16(texts.Count)]);
            texts.AddRange(bytes);
        }

        return [.. U16(0), .. U16(names.Length), .. U16(6 + records.Count), .. records, .. texts];
    }

    /// <summary>The file: its directory, then the tables, each from a multiple of four bytes on.</summary>
    private static byte[] Assemble(SortedDictionary<string, byte[]> tables)
    {
        var (directory, bodies) = (new List<byte>(), new List<byte>());
        var power = (int)Math.Log2(tables.Count);
        directory.AddRange([.. U32(0x10000), .. U16(tables.Count), .. U16(16 << power), .. U16(power), .. U16((tables.Count * 16) - (16 << power))]);
        var first = directory.Count + (16 * tables.Count);
        foreach (var (tag, data) in tables)
        {
            directory.AddRange([.. Encoding.ASCII.GetBytes(tag), .. U32(ChecksumOf(data)), .. U32(first + bodies.Count), .. U32(data.Length)]);
            bodies.AddRange([.. data, .. new byte[(4 - (data.Length % 4)) % 4]]);
        }

        byte[] file = [.. directory, .. bodies];
        var head = first + tables.TakeWhile(table => table.Key != "head").Sum(table => (table.Value.Length + 3) / 4 * 4);
        U32(unchecked((int)(0xB1B0AFBA - (uint)ChecksumOf(file)))).CopyTo(file, head + 8);
        return file;
    }

    private static int ChecksumOf(byte[] data)
    {
        byte[] padded = [.. data, .. new byte[(4 - (data.Length % 4)) % 4]];
        var sum = 0U;
        for (var i = 0; i < padded.Length; i += 4)
        {
            sum = unchecked(sum + BinaryPrimitives.ReadUInt32BigEndian(padded.AsSpan(i)));
        }

        return unchecked((int)sum);
    }

    private static byte[] U16(int value)
    {
        var bytes = new byte[2];
        BinaryPrimitives.WriteUInt16BigEndian(bytes, unchecked((ushort)value));
        return bytes;
    }

    private static byte[] U32(int value)
    {
        var bytes = new byte[4];
        BinaryPrimitives.WriteInt32BigEndian(bytes, value);
        return bytes;
    }
}
