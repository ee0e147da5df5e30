using System.Collections.Concurrent;
using System.Text;

namespace Engraver.Fonts.OpenType;

/// <summary>One face of a font file or of a collection: its tables by name (OpenType 1.9, "Organization of an OpenType font").</summary>
public sealed class FontFile
{
    private const uint CollectionTag = 0x74746366;
    private const int MaxFaces = 1024;

    private readonly IFontSource _source;
    private readonly Dictionary<uint, (uint Offset, uint Length)> _places = [];
    private readonly ConcurrentDictionary<uint, ReadOnlyMemory<byte>> _tables = new();

    /// <exception cref="BrokenFontException">Not a font, or no face of that number.</exception>
    public FontFile(IFontSource source, int face = 0)
    {
        _source = source;
        var start = StartOf(source, face);
        var header = new FontBytes(source.Read(start, 12));
        if (header.UInt32(0) is not (0x00010000 or 0x4F54544F or 0x74727565))
            throw new BrokenFontException("The file is not a TrueType or OpenType font.");
        int count = header.UInt16(4);
        var records = new FontBytes(source.Read(start + 12, 16 * count));
        for (var i = 0; i < count; i++)
            _places[records.UInt32(16 * i)] = (records.UInt32(16 * i + 8), records.UInt32(16 * i + 12));
    }

    /// <summary>Number of faces in the file; 1 for a plain font.</summary>
    public static int CountFaces(IFontSource source)
    {
        var header = new FontBytes(source.Read(0, 12));
        return header.UInt32(0) == CollectionTag ? (int)Math.Min(header.UInt32(8), MaxFaces) : 1;
    }

    public bool Has(string name) => _places.ContainsKey(Tag(name));

    public bool TryGetTable(uint tag, out ReadOnlyMemory<byte> table)
    {
        table = default;
        if (!_places.TryGetValue(tag, out var place))
            return false;
        if (place.Offset > _source.Length || place.Length > _source.Length - place.Offset)
            return false;
        table = _tables.GetOrAdd(tag, _ => _source.Read(place.Offset, (int)place.Length));
        return true;
    }

    /// <exception cref="BrokenFontException">There is no such table.</exception>
    public FontBytes Table(string name) =>
        TryGetTable(Tag(name), out var table) ? new FontBytes(table) : throw new BrokenFontException($"The font has no table {name}.");

    public ReadOnlyMemory<byte> WholeFile() => _source.Read(0, (int)_source.Length);

    private static uint Tag(string name) => new FontBytes(Encoding.ASCII.GetBytes(name)).UInt32(0);

    private static long StartOf(IFontSource source, int face)
    {
        if (face < 0 || face >= CountFaces(source))
            throw new BrokenFontException("The collection has no face of that number.");
        var isCollection = new FontBytes(source.Read(0, 12)).UInt32(0) == CollectionTag;
        return isCollection ? new FontBytes(source.Read(12 + 4L * face, 4)).UInt32(0) : 0;
    }
}
