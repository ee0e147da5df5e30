namespace Engraver.Workbench.Commands.Session;

/// <summary>SELECT: Selects objects for the next command.</summary>
internal sealed class SelectCommand : ICommand
{
    public CommandInfo Info { get; } = new("SELECT", CommandGroup.Ask);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.PickAsync(context, takesTexts: true).ConfigureAwait(false);
        context.Document.Select(selected, selected);
    }
}
