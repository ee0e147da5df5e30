namespace Engraver.Workbench.Commands;

/// <summary>HIDEOBJECTS: Hides objects; what is hidden is not cut either. UNISOLATEOBJECTS shows them again.</summary>
internal sealed class HideObjectsCommand : ICommand
{
    public CommandInfo Info { get; } = new("HIDEOBJECTS", CommandGroup.Drawing, "Hides objects; what is hidden is not cut either. UNISOLATEOBJECTS shows them again.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.TakeAsync(context).ConfigureAwait(false);
        var state = context.Document.Current;
        context.Take(state with { Drawing = DrawingChange.WithHidden(context.Drawing, selected, hidden: true), Edition = state.Edition, HiddenObjects = [.. state.HiddenObjects, .. selected], Selection = [], Previous = [] });
        context.Say(FormattableString.Invariant($"{selected.Count} hidden; they are not cut."));
    }
}
