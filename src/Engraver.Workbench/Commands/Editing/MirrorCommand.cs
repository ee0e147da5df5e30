using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>MIRROR: Mirrors objects about a line; arcs stay arcs and change their direction.</summary>
internal sealed class MirrorCommand : ICommand
{
    public CommandInfo Info { get; } = new("MIRROR", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.TakeAsync(context).ConfigureAwait(false);
        var first = await context.ValueAsync(new PointPrompt(Wording.Get("Mirror.SpecifyFirstPointMirror"))).ConfigureAwait(false);
        var second = await context.ValueAsync(new PointPrompt(Wording.Get("Mirror.SpecifySecondPointMirror")) { From = first }).ConfigureAwait(false);
        if (first == second) throw new CommandException(CommandFailure.Usage, Wording.Get("Mirror.MirrorLineNeedsTwo"));
        var erase = await context.ConfirmAsync(Wording.Get("Mirror.EraseSourceObjects")).ConfigureAwait(false);
        DrawingChange.Transform(context, selected, Transform2D.MirrorAt(first, second), copy: !erase);
    }
}
