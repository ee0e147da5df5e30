using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Files;

/// <summary>NEW: Creates an empty drawing, in millimetres unless another unit is set. It gets a file when it is saved. The operator is asked first whether
/// edits of the open drawing are saved; in a script UNDO restores them.</summary>
internal sealed class NewCommand : ICommand
{
    public CommandInfo Info { get; } = new("NEW", CommandGroup.File) { ReplacesDrawing = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var document = context.Document;
        if (context.IsInteractive && document.IsEdited && await context.ChoiceAsync(Wording.Get("New.SaveFirst", Path.GetFileName(document.FilePath)), Keyword.List("Yes", "No"), "Yes").ConfigureAwait(false) == "Yes")
        {
            await QSaveCommand.SaveAsync(context, mayReplace: true).ConfigureAwait(false);
        }

        NewDrawing.Create(context);
    }
}
