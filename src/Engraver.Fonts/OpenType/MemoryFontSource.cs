namespace Engraver.Fonts.OpenType;

/// <summary>A font that is in memory as a whole, such as an embedded one.</summary>
public sealed class MemoryFontSource(ReadOnlyMemory<byte> file) : IFontSource
{
    public long Length => file.Length;

    public ReadOnlyMemory<byte> Read(long offset, int length)
    {
        if (offset < 0 || length < 0 || offset > file.Length - length)
            throw new BrokenFontException("The font file ends in the middle.");
        return file.Slice((int)offset, length);
    }
}
