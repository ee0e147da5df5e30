namespace Engraver.Workbench.Commands.Editing;

/// <summary>ERASE: Removes objects from the drawing.</summary>
internal sealed class EraseCommand : ICommand
{
    public CommandInfo Info { get; } = new("ERASE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetForEditAsync(context, takesTexts: true).ConfigureAwait(false);
        DrawingChange.Erase(context, selected);
    }
}
