using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>MIRROR: Mirrors objects at a line; arcs stay arcs and turn their sense round.</summary>
internal sealed class MirrorCommand : ICommand
{
    public CommandInfo Info { get; } = new("MIRROR", CommandGroup.Drawing, "Mirrors objects at a line; arcs stay arcs and turn their sense round.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.TakeAsync(context).ConfigureAwait(false);
        var first = await context.ValueAsync(new PointPrompt("Specify first point of mirror line")).ConfigureAwait(false);
        var second = await context.ValueAsync(new PointPrompt("Specify second point of mirror line") { From = first }).ConfigureAwait(false);
        if (first == second) throw new CommandException(CommandFailure.Usage, "The mirror line needs two different points.");
        var erase = await context.ConfirmAsync("Erase source objects?").ConfigureAwait(false);
        DrawingChange.Transform(context, selected, Transform2D.MirrorAt(first, second), copy: !erase);
    }
}
