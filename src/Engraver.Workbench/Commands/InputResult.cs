namespace Engraver.Workbench.Commands;

/// <summary>Result of one input.</summary>
public abstract record InputResult
{
    private InputResult()
    {
    }

    /// <summary>The command waits for input: see the current prompt.</summary>
    public sealed record AwaitingInput : InputResult;

    /// <summary>The command has succeeded, or there was nothing to do.</summary>
    public sealed record Done : InputResult;

    /// <summary>Esc, or the operator's stop.</summary>
    public sealed record Cancelled : InputResult;

    /// <summary>The input was rejected; command and prompt are unchanged.</summary>
    public sealed record NotAccepted(string Message) : InputResult;

    /// <summary>The command failed.</summary>
    public sealed record Failed(CommandFailure Reason, string Message) : InputResult
    {
        /// <summary>The unexpected exception; null unless <see cref="Reason"/> is <see cref="CommandFailure.Internal"/>.</summary>
        public Exception? Exception { get; init; }
    }
}
