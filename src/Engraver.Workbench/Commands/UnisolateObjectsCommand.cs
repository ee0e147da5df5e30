namespace Engraver.Workbench.Commands;

/// <summary>UNISOLATEOBJECTS: Shows what HIDEOBJECTS has hidden; it is cut again.</summary>
internal sealed class UnisolateObjectsCommand : ICommand
{
    public CommandInfo Info { get; } = new("UNISOLATEOBJECTS", CommandGroup.Drawing, "Shows what HIDEOBJECTS has hidden; it is cut again.");

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var state = context.Document.Current;
        if (state.HiddenObjects.Count > 0) context.Take(state with { Drawing = DrawingChange.WithHidden(drawing, state.HiddenObjects, hidden: false), Edition = state.Edition, HiddenObjects = [] });
        context.Say(FormattableString.Invariant($"{state.HiddenObjects.Count} shown again."));
        return Task.CompletedTask;
    }
}
