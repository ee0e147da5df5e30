namespace Engraver.Workbench.Commands;

/// <summary>U: Takes back the last step.</summary>
internal sealed class UCommand : ICommand
{
    public CommandInfo Info { get; } = new("U", CommandGroup.File, "Takes back the last step.");

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.Say(context.Document.Undo() ?? "Everything has been undone.");
        return Task.CompletedTask;
    }
}
