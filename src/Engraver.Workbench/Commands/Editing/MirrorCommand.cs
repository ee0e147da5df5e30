using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>MIRROR: Mirrors objects about a line; arcs stay arcs and change their direction.</summary>
internal sealed class MirrorCommand : ICommand
{
    public CommandInfo Info { get; } = new("MIRROR", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetForEditAsync(context, takesTexts: true).ConfigureAwait(false);
        var keepsTexts = DrawingChange.KeepsTextDirection(context);
        var ghost = new SelectionGhost(context.Drawing, selected);
        var first = await context.ValueAsync(new PointPrompt(Wording.Get("Mirror.SpecifyFirstPoint"))).ConfigureAwait(false);
        var second = await context.ValueAsync(new PointPrompt(Wording.Get("Mirror.SpecifySecondPoint")) { From = first, Ghost = place => place == first ? [] : ghost.Mirrored(Transform2D.MirrorAt(first, place), keepsTexts) }).ConfigureAwait(false);
        if (first == second) throw new CommandException(CommandFailure.Usage, Wording.Get("Mirror.PointsCoincide"));
        var question = new ChoicePrompt(Wording.Get("Mirror.EraseSource")) { Options = Keyword.List("Yes", "No"), Default = "No", Preview = _ => ghost.Mirrored(Transform2D.MirrorAt(first, second), keepsTexts) };
        var erase = await context.AskAsync(question).ConfigureAwait(false) is Answer<string>.SelectedOption { Option: "Yes" };
        if (keepsTexts && selected.Any(index => index >= context.Drawing.Entities.Count)) context.WriteMessage(Wording.Get("Mirror.TextsReadable"));
        DrawingChange.Transform(context, selected, Transform2D.MirrorAt(first, second), copy: !erase);
    }
}
