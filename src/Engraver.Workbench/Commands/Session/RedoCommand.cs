using Engraver.Core.Languages;

namespace Engraver.Workbench.Commands.Session;

/// <summary>REDO: Repeats the step that was undone last.</summary>
internal sealed class RedoCommand : ICommand
{
    public CommandInfo Info { get; } = new("REDO", CommandGroup.File);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.WriteMessage(context.Document.Redo() is { } name ? TextCatalogue.Fact(name) : Wording.Get("Undo.EverythingHasBeenRedone"));
        return Task.CompletedTask;
    }
}
