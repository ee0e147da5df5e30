namespace Engraver.Workbench.Commands.Editing;

/// <summary>HIDEOBJECTS: Hides objects; hidden objects are not cut. UNISOLATEOBJECTS shows them again.</summary>
internal sealed class HideObjectsCommand : ICommand
{
    public CommandInfo Info { get; } = new("HIDEOBJECTS", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.TakeAsync(context).ConfigureAwait(false);
        var state = context.Document.Current;
        context.Take(state with { Drawing = DrawingChange.WithHidden(context.Drawing, selected, hidden: true), Edition = state.Edition, HiddenObjects = [.. state.HiddenObjects, .. selected], Selection = [], Previous = [] });
        context.Say(Wording.Get("HideObjects.Hidden", selected.Count));
    }
}

/// <summary>UNISOLATEOBJECTS: Shows the objects hidden by HIDEOBJECTS; they are cut again.</summary>
internal sealed class UnisolateObjectsCommand : ICommand
{
    public CommandInfo Info { get; } = new("UNISOLATEOBJECTS", CommandGroup.Drawing);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var state = context.Document.Current;
        if (state.HiddenObjects.Count > 0) context.Take(state with { Drawing = DrawingChange.WithHidden(drawing, state.HiddenObjects, hidden: false), Edition = state.Edition, HiddenObjects = [] });
        context.Say(Wording.Get("HideObjects.ShownAgain", state.HiddenObjects.Count));
        return Task.CompletedTask;
    }
}
