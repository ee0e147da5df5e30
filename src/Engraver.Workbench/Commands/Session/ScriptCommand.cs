using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Session;

/// <summary>SCRIPT: Runs the commands of a script file (.scr).</summary>
internal sealed class ScriptCommand : ICommand
{
    public CommandInfo Info { get; } = new("SCRIPT", CommandGroup.File) { RunsOtherCommands = true, ReplacesDrawing = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var name = await context.ValueAsync(new FilePrompt(Wording.Get("Script.EnterFileName"), new FileRequest("script", false, ".scr"))).ConfigureAwait(false);
        context.QueueScript(context.ResolveInputPath(name), await File.ReadAllTextAsync(context.ResolveInputPath(name), cancellation).ConfigureAwait(false));
    }
}
