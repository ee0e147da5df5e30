namespace Engraver.Workbench.Commands.Files;

/// <summary>QSAVE: Saves an edited drawing in its file (the last one of SAVEAS, otherwise the opened one), and its sidecar.</summary>
internal sealed class QSaveCommand : ICommand
{
    public CommandInfo Info { get; } = new("QSAVE", CommandGroup.File);

    public Task RunAsync(CommandContext context, CancellationToken cancellation) => SaveAsync(context, mayReplace: false);

    /// <summary>Saves the drawing in its own file; a new drawing as SAVEAS does.</summary>
    /// <param name="mayReplace">The operator has already agreed.</param>
    public static async Task SaveAsync(CommandContext context, bool mayReplace)
    {
        _ = context.Drawing;
        if (!context.Document.HasFile)
        {
            await SaveAsCommand.SaveAsync(context).ConfigureAwait(false);
            return;
        }

        var path = context.Document.FilePath!;
        if (context.Document.IsDrawingEdited)
        {
            DrawingSaving.WarnLostContent(context);
            if (!mayReplace && !await context.ConfirmAsync(Wording.Get("QSave.Replace", Path.GetFileName(path))).ConfigureAwait(false)) throw new CommandException(CommandFailure.Usage, Wording.Get("ResultFile.NotReplaced", Path.GetFileName(path)));
            DrawingSaving.WriteDrawing(context, Path.GetFileName(path), path);
        }

        var written = DrawingSaving.WriteSidecar(context, path);
        if (!context.Document.IsDrawingEdited && !written) context.WriteMessage(Wording.Get("QSave.NoChanges"));
        context.Document.MarkSaved(path);
    }
}
