namespace Engraver.Fonts.OpenType;

/// <summary>The bytes of a font file in any storage.</summary>
public interface IFontSource
{
    long Length { get; }

    /// <exception cref="BrokenFontException">The range is not in the file, or the file cannot be read.</exception>
    ReadOnlyMemory<byte> Read(long offset, int length);
}
