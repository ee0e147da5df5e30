using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Session;

/// <summary>SCRIPT: Runs the commands of a script file (.scr).</summary>
internal sealed class ScriptCommand : ICommand
{
    public CommandInfo Info { get; } = new("SCRIPT", CommandGroup.File) { RunsOthers = true, BringsDrawing = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var name = await context.ValueAsync(new FilePrompt(Wording.Get("Script.EnterFileName"), new FileWanted("script", false, ".scr"))).ConfigureAwait(false);
        context.QueueScript(context.FileToRead(name), await File.ReadAllTextAsync(context.FileToRead(name), cancellation).ConfigureAwait(false));
    }
}
