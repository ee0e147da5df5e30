namespace Engraver.Workbench.Commands;

/// <summary>One thing a person can do. A menu item, a key, a typed word, a script line and a test all run the same one.</summary>
public interface ICommand
{
    CommandInfo Info { get; }

    /// <summary>Asks for what it needs, then does it. A document step is taken at the very end, so that Esc anywhere leaves everything as it was.</summary>
    /// <exception cref="CommandException">It cannot be done; the sentence says why.</exception>
    Task RunAsync(CommandContext context, CancellationToken cancellation);
}
