using System.Collections.Concurrent;
using System.Security.Cryptography;
using Engraver.Fonts.OpenType;
using Engraver.Fonts.StrokeFiles;

namespace Engraver.Fonts.Finding;

/// <summary>Opens font files of every format, each face once.</summary>
internal sealed class FontFiles
{
    /// <summary>The largest known font files have about 100 MB.</summary>
    private const long MaxLength = 256L << 20;

    private readonly ConcurrentDictionary<(string Path, int Face), Lazy<OpenedFont?>> _fonts = new();

    /// <returns>Null if the file cannot be read as a font.</returns>
    public OpenedFont? Open(string path, int face = 0) => _fonts.GetOrAdd((path, face), key => new Lazy<OpenedFont?>(() => Read(key.Path, key.Face))).Value;

    private static OpenedFont? Read(string path, int face)
    {
        try
        {
            var source = new DiskFontSource(path);
            if (source.Length > MaxLength) return null;
            var bytes = source.Read(0, (int)source.Length);
            return new OpenedFont(FontOf(path, bytes, face), path, Convert.ToHexStringLower(SHA256.HashData(bytes.Span)));
        }
        catch (BrokenFontException)
        {
            return null;
        }
    }

    private static ITextFont FontOf(string path, ReadOnlyMemory<byte> bytes, int face)
    {
        var name = Path.GetFileNameWithoutExtension(path);
        return Path.GetExtension(path).ToUpperInvariant() switch
        {
            ".SHX" => ShxFont.Read(bytes, name),
            ".LFF" => LffFont.Read(bytes, name),
            ".JHF" => JhfFont.Read(bytes, name),
            _ => new OutlineFont(new MemoryFontSource(bytes), face),
        };
    }
}
