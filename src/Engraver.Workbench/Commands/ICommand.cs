namespace Engraver.Workbench.Commands;

/// <summary>A command. Menu items, keys, typed input, scripts and tests run the same commands.</summary>
public interface ICommand
{
    CommandInfo Info { get; }

    /// <summary>Prompts for its input, then runs. The document step is committed at the end, so that Esc at any prompt leaves the document unchanged.</summary>
    /// <exception cref="CommandException">The command failed; the message states the reason.</exception>
    Task RunAsync(CommandContext context, CancellationToken cancellation);
}
