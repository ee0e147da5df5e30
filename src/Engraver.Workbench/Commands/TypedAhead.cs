using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>Inputs that were typed while a command works: they are run when it has ended as it should, in their order. None of them acts on the machine:
/// nobody looks at a machine when words that were typed earlier come to it.</summary>
/// <remarks>Whoever feeds the session asks <see cref="BesideCommands.Takes"/> and <see cref="WhyNot"/> when an input is typed, and hands it to
/// <see cref="EnterAsync"/> when its turn has come.</remarks>
public sealed class TypedAhead(CommandSession session)
{
    private int _flushed;

    /// <summary>Changes whenever everything that waits is to be forgotten.</summary>
    public int Flushed => Volatile.Read(ref _flushed);

    /// <summary>Esc or a stop: what was typed before is not run any more. From any thread.</summary>
    public void Flush() => Interlocked.Increment(ref _flushed);

    /// <summary>Why this input is not kept until the command at work has ended, a sentence; null when it is.</summary>
    public string? WhyNot(string input)
    {
        ArgumentNullException.ThrowIfNull(input);
        if (input.Trim().Length == 0) return Wording.Get("TypedAhead.EnterAlone");
        if (session.IsMachineAtWork) return session.Beside.WhyNot(input) ?? Wording.Get("TypedAhead.MachineBusy", input.Trim());
        return Meant(input) is { } command && MayMove(command) ? Wording.Get("TypedAhead.ActsOnTheMachine", command.Name) : null;
    }

    /// <summary>Runs an input that was kept.</summary>
    /// <param name="input">As it was typed.</param>
    /// <param name="typedAt">What <see cref="Flushed"/> was then.</param>
    /// <param name="before">How the input before it ended.</param>
    public async Task<InputResult> EnterAsync(string input, int typedAt, InputResult before, CancellationToken cancellation)
    {
        if (typedAt != Flushed || before is not (InputResult.Done or InputResult.Asking)) return Dropped(Wording.Get("TypedAhead.NotRun", input));
        var asks = session.Prompt.Command is { } name ? session.Catalog.Find(name)?.Info : null;
        if (asks is { } asking && MayMove(asking)) return Dropped(Wording.Get("TypedAhead.NotAnAnswer", input, asking.Name));
        return asks is null && WhyNot(input) is { } forbidden ? Dropped(forbidden) : await session.EnterAsync(input, cancellation).ConfigureAwait(false);
    }

    private InputResult.Cancelled Dropped(string why)
    {
        session.Say(MessageKind.Warning, why);
        return new InputResult.Cancelled();
    }

    private CommandInfo? Meant(string input) => CommandNames.Find(input.Trim(), session.Catalog, session.Aliases)?.Info;

    private static bool MayMove(CommandInfo command) => command.StartsMotion || command.RunsOthers || command.Group == CommandGroup.Machine;
}
