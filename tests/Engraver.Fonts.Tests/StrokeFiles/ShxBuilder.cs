using System.Text;

namespace Engraver.Fonts.Tests.StrokeFiles;

/// <summary>Writes a compiled shape file byte by byte.</summary>
internal sealed class ShxBuilder(string kind, int above = 6, int below = 2)
{
    private readonly SortedDictionary<int, (string Name, byte[] Codes)> _shapes = [];

    public string Name { get; init; } = "Written";

    /// <summary>Codes of a definition are written without the zero at the end.</summary>
    public byte[] Definition { get; init; } = kind.StartsWith("unifont", StringComparison.Ordinal) ? [(byte)above, (byte)below, 0, 0, 0] : [(byte)above, (byte)below, 0];

    public ShxBuilder With(int number, params byte[] codes) => Named(number, "", [.. codes, 0]);

    /// <param name="codes">All of them, the end included.</param>
    public ShxBuilder Named(int number, string name, byte[] codes)
    {
        _shapes[number] = (name, codes);
        return this;
    }

    public byte[] Build()
    {
        byte[] header = [.. Encoding.ASCII.GetBytes($"AutoCAD-86 {kind}\r\n"), 0x1A];
        var shapes = _shapes.Select(shape => (Number: shape.Key, Record: Record(shape.Value.Name, shape.Value.Codes))).Prepend((Number: 0, Record: Record(Name, [.. Definition, 0]))).ToList();
        return kind.StartsWith("unifont", StringComparison.Ordinal)
            ? [.. header, .. Low(shapes.Count), .. shapes.SelectMany(shape => (byte[])[.. Low(shape.Number), .. Low(shape.Record.Length), .. shape.Record])]
            : [.. header, .. Low(shapes[0].Number), .. Low(shapes[^1].Number), .. Low(shapes.Count), .. shapes.SelectMany(shape => (byte[])[.. Low(shape.Number), .. Low(shape.Record.Length)]),
                .. shapes.SelectMany(shape => shape.Record), .. "EOF"u8];
    }

    private static byte[] Record(string name, byte[] codes) => [.. Encoding.Latin1.GetBytes(name), 0, .. codes];

    private static byte[] Low(int value) => [(byte)value, (byte)(value >> 8)];
}
