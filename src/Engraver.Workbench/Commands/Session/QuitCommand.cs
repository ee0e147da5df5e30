using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Session;

/// <summary>QUIT: Closes the window, which warns first where a job runs and asks whether edits are saved. Enter alone is not the second QUIT that ends a
/// job.</summary>
internal sealed class QuitCommand : ICommand
{
    public CommandInfo Info { get; } = new("QUIT", CommandGroup.File) { HeardDuringJob = true, IsRepeated = false };

    public Task RunAsync(CommandContext context, CancellationToken cancellation) =>
        context.OpensDialog() ? Task.CompletedTask : throw new CommandException(CommandFailure.Usage, Wording.Get("Quit.NoWindow"));
}
