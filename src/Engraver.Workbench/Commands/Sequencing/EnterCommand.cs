using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Sequencing;

/// <summary>ENTER: Names the entity where cutting begins.</summary>
internal sealed class EnterCommand : ICommand
{
    public CommandInfo Info { get; } = new("ENTER", CommandGroup.Sequence);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var answer = await context.AskAsync(new PointPrompt(Wording.Get("Enter.SelectEnteringEntity")) { Options = Keyword.List("Handle", "Point", "None"), Purpose = PointPurpose.Object }).ConfigureAwait(false);
        var place = answer switch
        {
            Answer<Point2D>.Value { Result: var point } => AtEntity(drawing, ObjectSelection.EntityAt(context, point) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("Enter.NoObjectAtPoint"))),
            Answer<Point2D>.SelectedOption { Option: "Handle" } => new ContourEntry.ByHandle(await HandleAsync(context).ConfigureAwait(false)),
            Answer<Point2D>.SelectedOption { Option: "Point" } => new ContourEntry.ByPoint(drawing.Scale.ToMillimetres(await context.ValueAsync(new PointPrompt(Wording.Get("Enter.SpecifyEnteringPoint"))).ConfigureAwait(false))),
            _ => null,
        };
        var state = context.Document.Current;
        var changed = state.Settings with { Enter = place };
        if (SettingTable.Operations.Conflict(changed) is { } conflict) throw new CommandException(CommandFailure.Usage, SettingWording.AtCommandLine(conflict));
        context.Commit(state with { Settings = changed });
    }

    /// <summary>Identifies the entity by its handle if it is unique, otherwise by a point on it: curves of a block's copies share their handle.</summary>
    private static ContourEntry AtEntity(Drawing drawing, int entity) =>
        drawing.SourceOf(entity).Handle is { } handle && drawing.IndexOfHandle(handle) == entity
            ? new ContourEntry.ByHandle(handle)
            : new ContourEntry.ByPoint(drawing.Scale.ToMillimetres(DrawingPick.Segments(drawing, entity).First().Start));

    private static async Task<string> HandleAsync(CommandContext context)
    {
        var handle = await context.ValueAsync(new TextPrompt(Wording.Get("Common.EnterHandle"))).ConfigureAwait(false);
        return context.Drawing.IndexOfHandle(handle) is null ? throw new CommandException(CommandFailure.Usage, Wording.Get("Enter.HandleNotFound", handle)) : handle;
    }
}
