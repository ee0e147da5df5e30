using System.Buffers.Binary;
using System.Text;

namespace Engraver.TestKit;

/// <summary>Writes small fonts: 1000 units per em, glyph 0 blank, glyph 1 as required, both 600 wide; the given characters map to glyph 1.</summary>
public sealed class FontBuilder
{
    private readonly SortedDictionary<string, byte[]> _tables = new(StringComparer.Ordinal);
    private readonly bool _isCff;

    private FontBuilder(string family, bool isCff, int cmapFormat, params int[] characters)
    {
        _isCff = isCff;
        _tables["head"] = [.. U32(0x10000), .. U32(0), .. U32(0), .. U32(0x5F0F3CF5), .. U16(0), .. U16(1000), .. new byte[16], .. U16(0), .. U16(0), .. U16(700), .. U16(700), .. U16(0), .. U16(8), .. U16(2), .. U16(0), .. U16(0)];
        _tables["hhea"] = [.. U32(0x10000), .. U16(800), .. U16(-200), .. U16(0), .. U16(600), .. new byte[22], .. U16(1)];
        _tables["maxp"] = [.. U32(0x10000), .. U16(2), .. new byte[26]];
        _tables["hmtx"] = [.. U16(600), .. U16(0), .. U16(0)];
        _tables["OS/2"] = [.. U16(4), .. U16(600), .. U16(400), .. U16(5), .. new byte[54], .. U16(0x40), .. U16(characters[0]), .. U16(characters[^1]), .. U16(800), .. U16(-200), .. U16(0), .. U16(800), .. U16(200), .. new byte[18]];
        _tables["name"] = Name(family);
        _tables["cmap"] = Cmap(cmapFormat, characters);
        _tables["post"] = [.. U32(0x30000), .. new byte[28]];
    }

    /// <summary>Glyph 1 is a square of 400 units on the baseline at x = 100.</summary>
    public static FontBuilder TrueType(string family, int cmapFormat, params int[] characters)
    {
        var font = new FontBuilder(family, false, cmapFormat, characters);
        byte[] square = [.. U16(1), .. U16(100), .. U16(0), .. U16(500), .. U16(400), .. U16(3), .. U16(0), 1, 1, 1, 1, .. U16(100), .. U16(0), .. U16(400), .. U16(0), .. U16(0), .. U16(400), .. U16(0), .. U16(-400)];
        font._tables["hmtx"] = [.. U16(600), .. U16(0), .. U16(100)];
        font._tables["glyf"] = square;
        font._tables["loca"] = [.. U16(0), .. U16(0), .. U16(square.Length / 2)];
        return font;
    }

    public static FontBuilder Cff(string family, byte[] charstring, byte[]? localSubroutine = null, byte[]? globalSubroutine = null, params int[] characters)
    {
        var font = new FontBuilder(family, true, 4, characters.Length == 0 ? ['A'] : characters);
        font._tables["CFF "] = CffTable(charstring, localSubroutine, globalSubroutine);
        return font;
    }

    public FontBuilder With(string table, byte[] data)
    {
        _tables[table] = data;
        return this;
    }

    public FontBuilder Without(string table)
    {
        _tables.Remove(table);
        return this;
    }

    public byte[] Build() => Build(0);

    /// <summary>A collection of these fonts.</summary>
    public static byte[] Collection(params FontBuilder[] fonts)
    {
        var header = 12 + 4 * fonts.Length;
        var bodies = new List<byte>();
        var offsets = new List<byte>();
        foreach (var font in fonts)
        {
            offsets.AddRange(U32(header + bodies.Count));
            bodies.AddRange(font.Build(header + bodies.Count));
        }
        return [.. "ttcf"u8, .. U32(0x10000), .. U32(fonts.Length), .. offsets, .. bodies];
    }

    public static byte[] U16(int value)
    {
        var bytes = new byte[2];
        BinaryPrimitives.WriteUInt16BigEndian(bytes, (ushort)value);
        return bytes;
    }

    public static byte[] U32(long value)
    {
        var bytes = new byte[4];
        BinaryPrimitives.WriteUInt32BigEndian(bytes, (uint)value);
        return bytes;
    }

    /// <param name="start">The position of the font in its file; table offsets count from the file's start.</param>
    private byte[] Build(int start)
    {
        var directory = new List<byte>([.. _isCff ? "OTTO"u8.ToArray() : U32(0x10000), .. U16(_tables.Count), .. new byte[6]]);
        var body = new List<byte>();
        var first = start + 12 + 16 * _tables.Count;
        foreach (var (name, data) in _tables)
        {
            directory.AddRange([.. Encoding.ASCII.GetBytes(name), .. U32(0), .. U32(first + body.Count), .. U32(data.Length)]);
            body.AddRange(data);
            body.AddRange(new byte[(4 - data.Length % 4) % 4]);
        }
        return [.. directory, .. body];
    }

    private static byte[] Name(string family)
    {
        var text = Encoding.BigEndianUnicode.GetBytes(family);
        byte[] Record(int id) => [.. U16(3), .. U16(1), .. U16(0x409), .. U16(id), .. U16(text.Length), .. U16(0)];
        return [.. U16(0), .. U16(3), .. U16(6 + 36), .. Record(1), .. Record(4), .. Record(6), .. text];
    }

    private static byte[] Cmap(int format, int[] characters)
    {
        var sub = format switch { 4 => Format4(characters), 6 => Format6(characters), _ => Format12(characters) };
        return [.. U16(0), .. U16(1), .. U16(3), .. U16(format == 12 ? 10 : 1), .. U32(12), .. sub];
    }

    private static byte[] Format4(int[] characters)
    {
        int[] ends = [.. characters, 0xFFFF];
        byte[] body =
        [
            .. U16(2 * ends.Length), .. new byte[6], .. ends.SelectMany(U16), .. U16(0), .. ends.SelectMany(U16),
            .. ends.SelectMany(end => U16(1 - end)), .. new byte[2 * ends.Length],
        ];
        body[^(2 * ends.Length + 2)] = 0;
        body[^(2 * ends.Length + 1)] = 1;
        return [.. U16(4), .. U16(body.Length + 6), .. U16(0), .. body];
    }

    private static byte[] Format6(int[] characters)
    {
        int first = characters[0], count = characters[^1] - first + 1;
        var glyphs = Enumerable.Range(first, count).SelectMany(c => U16(characters.Contains(c) ? 1 : 0)).ToArray();
        return [.. U16(6), .. U16(10 + glyphs.Length), .. U16(0), .. U16(first), .. U16(count), .. glyphs];
    }

    private static byte[] Format12(int[] characters)
    {
        var groups = characters.SelectMany(c => (byte[])[.. U32(c), .. U32(c), .. U32(1)]).ToArray();
        return [.. U16(12), .. U16(0), .. U32(16 + groups.Length), .. U32(0), .. U32(characters.Length), .. groups];
    }

    private static byte[] CffTable(byte[] charstring, byte[]? local, byte[]? global)
    {
        byte[] head = [1, 0, 4, 1, .. Index("F"u8.ToArray())];
        byte[] strings = Index(), globals = global is null ? Index() : Index(global), glyphs = Index([14], charstring);
        byte[] details = local is null ? [] : [.. Integer(6), 19];
        var topLength = Index(new byte[5 + 1 + 10 + 1]).Length;
        var glyphsAt = head.Length + topLength + strings.Length + globals.Length;
        byte[] top = [.. Integer(glyphsAt), 17, .. Integer(details.Length), .. Integer(glyphsAt + glyphs.Length), 18];
        return [.. head, .. Index(top), .. strings, .. globals, .. glyphs, .. details, .. local is null ? [] : Index(local)];
    }

    private static byte[] Integer(int value) => [29, .. U32(value)];

    private static byte[] Index(params byte[][] items)
    {
        if (items.Length == 0)
            return [0, 0];
        var offsets = new List<byte>();
        var at = 1;
        foreach (var length in items.Select(item => item.Length).Append(0))
        {
            offsets.AddRange(U16(at));
            at += length;
        }
        return [.. U16(items.Length), 2, .. offsets, .. items.SelectMany(item => item)];
    }
}
