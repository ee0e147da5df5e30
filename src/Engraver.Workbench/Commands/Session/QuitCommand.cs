namespace Engraver.Workbench.Commands.Session;

/// <summary>QUIT: Closes the window after a warning if a job is running and a question about unsaved edits. A second QUIT ends a running job; Enter alone does
/// not repeat it.</summary>
internal sealed class QuitCommand : ICommand
{
    public CommandInfo Info { get; } = new("QUIT", CommandGroup.File) { IsAllowedDuringJob = true, IsRepeatable = false };

    public Task RunAsync(CommandContext context, CancellationToken cancellation) =>
        context.TryOpenDialog() ? Task.CompletedTask : throw new CommandException(CommandFailure.Usage, Wording.Get("Quit.NoWindow"));
}
