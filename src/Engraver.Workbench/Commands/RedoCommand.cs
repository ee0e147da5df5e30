namespace Engraver.Workbench.Commands;

/// <summary>REDO: Takes the step again that was undone last.</summary>
internal sealed class RedoCommand : ICommand
{
    public CommandInfo Info { get; } = new("REDO", CommandGroup.File, "Takes the step again that was undone last.");

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.Say(context.Document.Redo() ?? "Everything has been redone.");
        return Task.CompletedTask;
    }
}
