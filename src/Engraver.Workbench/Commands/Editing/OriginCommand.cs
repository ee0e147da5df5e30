using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>ORIGIN: Moves the whole drawing so that a point of it becomes 0,0.</summary>
internal sealed class OriginCommand : ICommand
{
    public CommandInfo Info { get; } = new("ORIGIN", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var answer = await context.AskAsync(new PointPrompt(Wording.Get("Origin.SpecifyPoint")) { Options = Keyword.List("Lowerleft", "Center") }).ConfigureAwait(false);
        var box = context.View.ExtentsOf(drawing);
        if (answer is Answer<Point2D>.SelectedOption && box.IsEmpty) throw new CommandException(CommandFailure.Usage, Wording.Get("Origin.NothingVisible"));
        var place = answer switch
        {
            Answer<Point2D>.Value { Result: var point } => point,
            Answer<Point2D>.SelectedOption { Option: "Center" } => new Point2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0),
            _ => new Point2D(box.MinX, box.MinY),
        };
        DrawingChange.TransformAll(context, Transform2D.Move(Point2D.Origin - place));
    }
}
