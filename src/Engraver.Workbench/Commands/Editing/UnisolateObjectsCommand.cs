namespace Engraver.Workbench.Commands.Editing;

/// <summary>UNISOLATEOBJECTS: Shows the objects hidden by HIDEOBJECTS; they are cut again.</summary>
internal sealed class UnisolateObjectsCommand : ICommand
{
    public CommandInfo Info { get; } = new("UNISOLATEOBJECTS", CommandGroup.Drawing);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var state = context.Document.Current;
        if (state.HiddenObjects.Count > 0) context.Commit(state with { Drawing = DrawingChange.WithHidden(drawing, state.HiddenObjects, hidden: false), Edition = state.Edition, HiddenObjects = [] });
        context.WriteMessage(Wording.Get("HideObjects.ShownAgain", state.HiddenObjects.Count));
        return Task.CompletedTask;
    }
}
