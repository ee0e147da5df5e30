using Engraver.Core.Languages;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Session;

/// <summary>UNDO: Undoes a number of steps.</summary>
internal sealed class UndoCommand : ICommand
{
    public CommandInfo Info { get; } = new("UNDO", CommandGroup.File);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var count = await context.ValueAsync(new NumberPrompt(Wording.Get("Undo.EnterNumber")) { Default = "1", Min = 1, Max = 32767, IsInteger = true }).ConfigureAwait(false);
        for (var step = 0; step < count; step++)
        {
            if (context.Document.Undo() is not { } name)
            {
                context.WriteMessage(Wording.Get("Undo.EverythingHasBeenUndone"));
                return;
            }

            context.WriteMessage(TextCatalogue.Fact(name));
        }
    }
}
