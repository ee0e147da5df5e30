namespace Engraver.Tools.CrossChecks;

/// <summary>The second reading cannot handle the drawing; the message is a noun phrase with the reason.</summary>
public sealed class CrossCheckException : Exception
{
    public CrossCheckException()
    {
    }

    public CrossCheckException(string message)
        : base(message)
    {
    }

    public CrossCheckException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
