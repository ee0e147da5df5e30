namespace Engraver.Workbench.Commands;

/// <summary>What one input led to.</summary>
public abstract record InputResult
{
    private InputResult()
    {
    }

    /// <summary>The command wants more: see the current prompt.</summary>
    public sealed record Asking : InputResult;

    /// <summary>The command has ended as it should, or there was nothing to do.</summary>
    public sealed record Done : InputResult;

    /// <summary>Esc, or the operator's stop.</summary>
    public sealed record Cancelled : InputResult;

    /// <summary>The input was not understood; command and prompt stand as before.</summary>
    public sealed record NotUnderstood(string Sentence) : InputResult;

    /// <summary>The command ended without doing what it should.</summary>
    public sealed record Failed(CommandFailure Why, string Sentence) : InputResult
    {
        /// <summary>The exception that is a bug; null unless <see cref="Why"/> is <see cref="CommandFailure.Internal"/>.</summary>
        public Exception? Bug { get; init; }
    }
}
