namespace Engraver.Fonts;

/// <summary>A font file has impossible content, or cannot be read. The message is for developers; a program names the font in its own words.</summary>
public sealed class BrokenFontException : Exception
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
