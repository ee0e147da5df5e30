namespace Engraver.SoftwarePlatform.Text;

/// <summary>A font file has impossible content. Never leaves the text folder: the font, or the glyph, is left out instead.</summary>
internal sealed class BrokenFontException : Exception
{
    public BrokenFontException()
    {
    }

    public BrokenFontException(string message)
        : base(message)
    {
    }

    public BrokenFontException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
