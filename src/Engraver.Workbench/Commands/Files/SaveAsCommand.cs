namespace Engraver.Workbench.Commands.Files;

/// <summary>SAVEAS: Writes the drawing as edited, as DXF: every curve as what it is, with its height, layer and colour, and the texts.</summary>
internal sealed class SaveAsCommand : ICommand
{
    public CommandInfo Info { get; } = new("SAVEAS", CommandGroup.File);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        DrawingSaving.SayRest(context);
        var name = await ReplacePrompt.AskAsync(context, Wording.Get("SaveAs.EnterNameDxfFile")).ConfigureAwait(false);
        DrawingSaving.WriteDrawing(context, name, context.FileToWrite(name));
        DrawingSaving.WriteSidecar(context, context.FileToWrite(name));
        context.Document.MarkKept();
    }
}

/// <summary>QSAVE: Saves the drawing in its own file, when it was edited, and what belongs to it beside it.</summary>
internal sealed class QSaveCommand : ICommand
{
    public CommandInfo Info { get; } = new("QSAVE", CommandGroup.File);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var path = context.Drawing.FileName;
        if (context.Document.IsDrawingEdited)
        {
            DrawingSaving.SayRest(context);
            if (!await context.ConfirmAsync(Wording.Get("QSave.Replace", Path.GetFileName(path))).ConfigureAwait(false)) throw new CommandException(CommandFailure.Usage, Wording.Get("ResultFile.NotReplaced", Path.GetFileName(path)));
            DrawingSaving.WriteDrawing(context, Path.GetFileName(path), path);
        }

        var written = DrawingSaving.WriteSidecar(context, path);
        if (!context.Document.IsDrawingEdited && !written) context.Say(Wording.Get("QSave.Nothing"));
        context.Document.MarkKept();
    }
}
