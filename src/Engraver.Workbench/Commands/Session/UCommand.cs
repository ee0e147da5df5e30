using Engraver.Core.Languages;

namespace Engraver.Workbench.Commands.Session;

/// <summary>U: Undoes the last step.</summary>
internal sealed class UCommand : ICommand
{
    public CommandInfo Info { get; } = new("U", CommandGroup.File);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.WriteMessage(context.Document.Undo() is { } name ? TextCatalogue.Fact(name) : Wording.Get("Undo.EverythingHasBeenUndone"));
        return Task.CompletedTask;
    }
}
