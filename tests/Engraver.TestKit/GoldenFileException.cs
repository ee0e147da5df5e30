namespace Engraver.TestKit;

/// <summary>A golden file is missing or differs; the message names the file and the first differing line.</summary>
public sealed class GoldenFileException : Exception
{
    public GoldenFileException()
    {
    }

    public GoldenFileException(string message)
        : base(message)
    {
    }

    public GoldenFileException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
