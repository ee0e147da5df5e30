using Microsoft.Win32.SafeHandles;

namespace Engraver.Workbench.Files;

/// <summary>Reads files as a whole; a large one on all cores, because on some computers the system needs as long to hand over 100 MB as the reader of a drawing to understand them.</summary>
public static class WholeFile
{
    /// <summary>Bytes from which on several threads are worth while.</summary>
    internal const long Large = 16_000_000;

    /// <exception cref="IOException">It cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
    public static byte[] Read(string path) => Read(path, Large, Environment.ProcessorCount);

    /// <param name="large">Bytes from which on it is read in parts.</param>
    internal static byte[] Read(string path, long large, int parts)
    {
        if (parts < 2 || FileKind.IsStream(path)) return File.ReadAllBytes(path);
        using var file = File.OpenHandle(path);
        var length = RandomAccess.GetLength(file);
        if (length < large || length > Array.MaxLength) return File.ReadAllBytes(path);
        var bytes = GC.AllocateUninitializedArray<byte>((int)length);
        var isWhole = new bool[parts];
        Parallel.For(0, parts, part =>
        {
            var (from, to) = ((int)(length * part / parts), (int)(length * (part + 1) / parts));
            isWhole[part] = TryRead(file, from, bytes.AsSpan(from..to));
        });
        return Array.TrueForAll(isWhole, whole => whole) ? bytes : File.ReadAllBytes(path); // which says why, or reads what has become shorter meanwhile
    }

    private static bool TryRead(SafeFileHandle file, long from, Span<byte> bytes)
    {
        try
        {
            var done = 0;
            while (done < bytes.Length && RandomAccess.Read(file, bytes[done..], from + done) is > 0 and var count) done += count;
            return done == bytes.Length;
        }
        catch (IOException)
        {
            return false;
        }
    }
}
