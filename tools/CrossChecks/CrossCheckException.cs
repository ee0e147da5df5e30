namespace Engraver.Tools.CrossChecks;

/// <summary>The drawing is beyond what the second reading can judge; the message is a noun phrase that says why.</summary>
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
