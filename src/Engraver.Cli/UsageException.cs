namespace Engraver.Cli;

/// <summary>The value of an option is well-formed but cannot be used (an unknown layer, an unreadable profile). Ends the program with one sentence and exit
/// code 2.</summary>
public sealed class UsageException : Exception
{
    public UsageException()
    {
    }

    public UsageException(string message)
        : base(message)
    {
    }

    public UsageException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
