namespace Engraver.Workbench.Commands;

/// <summary>A command failed. The message is shown to the operator; the document is unchanged.</summary>
public sealed class CommandException : Exception
{
    public CommandException()
    {
    }

    public CommandException(string message)
        : base(message)
    {
    }

    public CommandException(string message, Exception inner)
        : base(message, inner)
    {
    }

    public CommandException(CommandFailure failure, string message)
        : base(message) => Failure = failure;

    public CommandFailure Failure { get; } = CommandFailure.Usage;
}
