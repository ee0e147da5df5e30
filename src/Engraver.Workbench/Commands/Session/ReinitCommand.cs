namespace Engraver.Workbench.Commands.Session;

/// <summary>REINIT: Reloads the alias files.</summary>
internal sealed class ReinitCommand : ICommand
{
    public CommandInfo Info { get; } = new("REINIT", CommandGroup.File);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var aliases = context.ReloadAliases();
        foreach (var finding in aliases.Findings) context.WriteMessage(finding, MessageKind.Warning);
        context.WriteMessage(Wording.Count("Reinit.Aliases", aliases.Commands.Count));
        return Task.CompletedTask;
    }
}
