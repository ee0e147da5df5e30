namespace Engraver.Core.SecondOpinions;

/// <summary>The drawing is beyond what the second reading can judge; the message is a noun phrase that says why.</summary>
public sealed class SecondOpinionException : Exception
{
    public SecondOpinionException()
    {
    }

    public SecondOpinionException(string message)
        : base(message)
    {
    }

    public SecondOpinionException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
