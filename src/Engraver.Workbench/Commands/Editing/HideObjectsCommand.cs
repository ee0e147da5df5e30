namespace Engraver.Workbench.Commands.Editing;

/// <summary>HIDEOBJECTS: Hides objects; hidden objects are not cut. UNISOLATEOBJECTS shows them again.</summary>
internal sealed class HideObjectsCommand : ICommand
{
    public CommandInfo Info { get; } = new("HIDEOBJECTS", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetAsync(context).ConfigureAwait(false);
        var state = context.Document.Current;
        context.Commit(state with { Drawing = DrawingChange.WithHidden(context.Drawing, selected, hidden: true), Edition = state.Edition, HiddenObjects = [.. state.HiddenObjects, .. selected], Selection = [], Previous = [] });
        context.WriteMessage(Wording.Get("HideObjects.Hidden", selected.Count));
    }
}
