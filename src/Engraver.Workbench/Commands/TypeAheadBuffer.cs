namespace Engraver.Workbench.Commands;

/// <summary>Inputs typed while a command works: they run in order after it has succeeded. None of them may act on the machine, because the operator may no
/// longer watch it when they run.</summary>
/// <remarks>The caller of the session asks <see cref="ConcurrentCommands.Accepts"/> and <see cref="RefusalOf"/> when an input is typed, and hands it to
/// <see cref="EnterAsync"/>.</remarks>
public sealed class TypeAheadBuffer(CommandSession session)
{
    private int _flushed;

    /// <summary>Incremented when all queued inputs are discarded.</summary>
    public int Flushed => Volatile.Read(ref _flushed);

    /// <summary>Esc or a stop: discards the inputs typed before. Any thread.</summary>
    public void Flush() => Interlocked.Increment(ref _flushed);

    /// <summary>Why this input cannot be queued until the running command has ended, a sentence; null if it can.</summary>
    public string? RefusalOf(string input)
    {
        ArgumentNullException.ThrowIfNull(input);
        if (input.Trim().Length == 0) return Wording.Get("TypeAheadBuffer.EnterAlone");
        if (session.IsMachineBusy) return session.Concurrent.WhyNot(input) ?? Wording.Get("TypeAheadBuffer.MachineBusy", input.Trim());
        return FindFirstWord(input) is { } command && CanMoveMachine(command) ? Wording.Get("TypeAheadBuffer.ActsOnTheMachine", command.Name) : null;
    }

    /// <summary>Runs a queued input.</summary>
    /// <param name="input">As typed.</param>
    /// <param name="typedAt">Value of <see cref="Flushed"/> at that time.</param>
    /// <param name="before">Result of the previous input.</param>
    public async Task<InputResult> EnterAsync(string input, int typedAt, InputResult before, CancellationToken cancellation)
    {
        if (typedAt != Flushed || before is not (InputResult.Done or InputResult.AwaitingInput)) return Discarded(Wording.Get("TypeAheadBuffer.NotRun", input));
        var asks = session.Prompt.Command is { } name ? session.Catalog.Find(name)?.Info : null;
        if (asks is { } asking && CanMoveMachine(asking)) return Discarded(Wording.Get("TypeAheadBuffer.NotAnAnswer", input, asking.Name));
        return asks is null && RefusalOf(input) is { } forbidden ? Discarded(forbidden) : await session.EnterAsync(input, cancellation).ConfigureAwait(false);
    }

    private InputResult.Cancelled Discarded(string why)
    {
        session.WriteMessage(MessageKind.Warning, why);
        return new InputResult.Cancelled();
    }

    private CommandInfo? FindFirstWord(string input) => CommandNames.Find(input.Trim(), session.Catalog, session.Aliases)?.Info;

    private static bool CanMoveMachine(CommandInfo command) => command.StartsMotion || command.RunsOtherCommands || command.Group == CommandGroup.Machine;
}
