using System.Text;

namespace Engraver.Fonts.StrokeFiles;

/// <summary>The shapes of a compiled shape file of AutoCAD, by number: "shapes 1.0", "shapes 1.1" (an index, then all data) or "unifont 1.0" (each number
/// with its data).</summary>
internal sealed class ShxFile
{
    /// <summary>Longer than every known first line.</summary>
    private const int MaxHeader = 80;
    private const byte EndOfHeader = 0x1A;

    private readonly Dictionary<int, ReadOnlyMemory<byte>> _shapes = [];

    private ShxFile(bool isUnicode) => IsUnicode = isUnicode;

    /// <summary>Numbers of shapes are characters of Unicode, and those of subshapes have two bytes.</summary>
    public bool IsUnicode { get; }

    /// <summary>Of the font, as shape 0 has it.</summary>
    public string Name { get; private set; } = "";

    /// <exception cref="BrokenFontException">Not an SHX file of a known kind, or invalid lengths.</exception>
    public static ShxFile Read(ReadOnlyMemory<byte> data)
    {
        var bytes = new ShxBytes(data);
        var header = Encoding.ASCII.GetString(bytes.TakeUntil(EndOfHeader, MaxHeader).Span).Trim();
        if (!header.StartsWith("AutoCAD-86 ", StringComparison.OrdinalIgnoreCase)) throw new BrokenFontException("The file is not a compiled shape file.");
        var file = new ShxFile(header.EndsWith(" unifont 1.0", StringComparison.OrdinalIgnoreCase));
        if (file.IsUnicode) file.ReadRecords(bytes);
        else if (header.EndsWith(" shapes 1.0", StringComparison.OrdinalIgnoreCase) || header.EndsWith(" shapes 1.1", StringComparison.OrdinalIgnoreCase)) file.ReadIndexed(bytes);
        else throw new BrokenFontException($"Shape files of this kind are not read: {header}");
        return file;
    }

    /// <returns>The codes of a shape; null if there is no such shape.</returns>
    public ReadOnlyMemory<byte>? Shape(int number) => _shapes.TryGetValue(number, out var codes) ? codes : default(ReadOnlyMemory<byte>?);

    private void ReadRecords(ShxBytes bytes)
    {
        // Some programs add a mark of their own after the last record.
        for (var left = bytes.NextUInt16(); left > 0; left--) Add(bytes.NextUInt16(), bytes.Take(bytes.NextUInt16()));
    }

    private void ReadIndexed(ShxBytes bytes)
    {
        // The lowest and the highest number.
        bytes.Take(4);
        var index = new (int Number, int Length)[bytes.NextUInt16()];
        for (var i = 0; i < index.Length; i++) index[i] = (bytes.NextUInt16(), bytes.NextUInt16());
        foreach (var (number, length) in index) Add(number, bytes.Take(length));
    }

    /// <param name="record">The name, a zero, the codes. A record without the zero has no codes: its shape is broken, not the font.</param>
    private void Add(int number, ReadOnlyMemory<byte> record)
    {
        var length = record.Span.IndexOf((byte)0);
        if (number == 0 && length > 0) Name = Encoding.Latin1.GetString(record.Span[..length]).Trim();
        if (!_shapes.TryAdd(number, length < 0 ? default : record[(length + 1)..])) throw new BrokenFontException($"The SHX file has shape {number} twice.");
    }
}
