namespace Engraver.Fonts.OpenType;

/// <summary>A font file on disk. It is opened for each read, so that thousands of installed fonts use no resources.</summary>
public sealed class DiskFontSource(string path) : IFontSource
{
    public long Length { get; } = LengthOf(path);

    public ReadOnlyMemory<byte> Read(long offset, int length)
    {
        if (offset < 0 || length < 0 || offset > Length - length)
            throw new BrokenFontException("The font file ends in the middle.");
        try
        {
            using var file = File.OpenHandle(path);
            var bytes = new byte[length];
            var done = 0;
            while (done < length)
            {
                var count = RandomAccess.Read(file, bytes.AsSpan(done), offset + done);
                if (count == 0)
                    throw new BrokenFontException("The font file became shorter.");
                done += count;
            }
            return bytes;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new BrokenFontException("The font file cannot be read.", e);
        }
    }

    private static long LengthOf(string path)
    {
        try
        {
            return new FileInfo(path).Length;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new BrokenFontException("The font file cannot be read.", e);
        }
    }
}
