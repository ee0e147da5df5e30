using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Files;

/// <summary>SAVEAS: Writes the edited drawing as DXF: every curve with its type, height, layer and colour, and the texts.</summary>
internal sealed class SaveAsCommand : ICommand
{
    public CommandInfo Info { get; } = new("SAVEAS", CommandGroup.File);

    public Task RunAsync(CommandContext context, CancellationToken cancellation) => SaveAsync(context);

    /// <summary>Asks for a file and writes the drawing there.</summary>
    public static async Task SaveAsync(CommandContext context)
    {
        DrawingSaving.WarnLostContent(context);
        var name = await ReplacePrompt.AskAsync(context, Wording.Get("SaveAs.EnterName"), new FileRequest(FileRequest.Drawing, true, ".dxf") { Suggested = context.PathBesideDrawing(".dxf") }, adds: true).ConfigureAwait(false);
        var path = context.ResolveOutputPath(name);
        DrawingSaving.WriteDrawing(context, name, path);
        DrawingSaving.WriteSidecar(context, path);
        context.Document.MarkSaved(path);
        context.Settings.Change(kept => kept.WithRecent(Path.GetFullPath(path)));
    }
}
