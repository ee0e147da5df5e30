using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>ARRAY: Copies objects in rows and columns, or around a point.</summary>
internal sealed class ArrayCommand : ICommand
{
    private const int MaxItems = 1000;
    private const int FirstItems = 6;
    private const double FullTurn = 360.0;

    public CommandInfo Info { get; } = new("ARRAY", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetAsync(context, takesTexts: true).ConfigureAwait(false);
        var ghost = new SelectionGhost(context.Drawing, selected);
        var type = await context.ChoiceAsync(Wording.Get("Array.EnterType"), Keyword.List("Rectangular", "POlar"), context.LastValue("ARRAY", "Rectangular")).ConfigureAwait(false);
        context.Remember("ARRAY", type);
        var maps = type == "Rectangular" ? await RectangularAsync(context, ghost).ConfigureAwait(false) : await PolarAsync(context, ghost).ConfigureAwait(false);
        var edited = context.Drawing;
        foreach (var map in maps)
        {
            cancellation.ThrowIfCancellationRequested();
            if (!DrawingEdit.TryCopy(edited, DrawingChange.CurvesOf(context.Drawing, selected), map, out edited)) throw new CommandException(CommandFailure.Usage, Wording.Get("Array.CopyOutOfRange"));
        }

        DrawingChange.Commit(context, DrawingChange.AnnotationsOf(context, selected, takesLocked: true).Copied(edited, maps), selected);
    }

    private static async Task<IReadOnlyList<Transform2D>> RectangularAsync(CommandContext context, SelectionGhost ghost)
    {
        var rows = await CountAsync(context, Wording.Get("Array.EnterRows"), 3, null).ConfigureAwait(false);
        var columns = await CountAsync(context, Wording.Get("Array.EnterColumns"), 4, null).ConfigureAwait(false);
        if (rows * columns > MaxItems) throw new CommandException(CommandFailure.Usage, Wording.Get("Array.TooManyCopies", rows * columns, MaxItems));
        var up = 0.0;
        if (rows > 1 && await DistanceAsync(context, ghost, Wording.Get("Array.EnterDistanceBetweenRows"), way => way.Y, Cells).ConfigureAwait(false) is var cell)
        {
            if (cell.X is { } wide) return Cells(new Vector2D(wide, cell.Y));
            up = cell.Y;
        }

        if (columns == 1) return Cells(new Vector2D(0.0, up));
        var across = await DistanceAsync(context, ghost, Wording.Get("Array.EnterDistanceBetweenColumns"), way => way.X, way => Cells(new Vector2D(way.X, up))).ConfigureAwait(false);
        return Cells(new Vector2D(across.X ?? across.Y, up));

        IReadOnlyList<Transform2D> Cells(Vector2D step) =>
            [.. from row in Enumerable.Range(0, rows) from column in Enumerable.Range(0, columns) where row + column > 0 select Transform2D.Move(new Vector2D(column * step.X, row * step.Y))];
    }

    /// <summary>A typed distance, or a unit cell given by two corners; the preview shows the copies for the cursor position.</summary>
    /// <returns>The typed number as Y, or both sides of the cell.</returns>
    private static async Task<(double? X, double Y)> DistanceAsync(CommandContext context, SelectionGhost ghost, string instruction, Func<Vector2D, double> measure, Func<Vector2D, IReadOnlyList<Transform2D>> maps)
    {
        var prompt = new AmountPrompt(instruction, measure) { Min = -Drawing.LargestCoordinate, Max = Drawing.LargestCoordinate };
        var answer = await context.ValueAsync(prompt).ConfigureAwait(false);
        if (answer is not Amount.FirstPoint { Point: var corner }) return (null, ((Amount.Number)answer).Value);
        var opposite = await context.ValueAsync(new PointPrompt(Wording.Get("Array.SpecifyOppositeCorner")) { From = corner, Ghost = place => ghost.Mapped(maps(place - corner)) }).ConfigureAwait(false);
        return (opposite.X - corner.X, opposite.Y - corner.Y);
    }

    private static async Task<IReadOnlyList<Transform2D>> PolarAsync(CommandContext context, SelectionGhost ghost)
    {
        var centre = await context.ValueAsync(new PointPrompt(Wording.Get("Array.SpecifyCentre")) { Ghost = place => ghost.Mapped(Around(place, FirstItems, FullTurn)) }).ConfigureAwait(false);
        var items = await CountAsync(context, Wording.Get("Array.EnterItems"), FirstItems, _ => ghost.Mapped(Around(centre, FirstItems, FullTurn))).ConfigureAwait(false);
        var fill = await context.ValueAsync(new NumberPrompt(Wording.Get("Array.SpecifyAngleFill")) { Default = "360", Min = -FullTurn, Max = FullTurn, Preview = _ => ghost.Mapped(Around(centre, items, FullTurn)) }).ConfigureAwait(false);
        return Around(centre, items, fill);
    }

    /// <param name="fill">Angle that all items fill, degrees; a full turn has neither gap nor duplicate.</param>
    private static IReadOnlyList<Transform2D> Around(Point2D centre, int items, double fill)
    {
        var step = Math.Abs(fill) == FullTurn ? fill / items : fill / Math.Max(1, items - 1);
        return [.. Enumerable.Range(1, items - 1).Select(item => Transform2D.Rotate(centre, Angle.FromDegrees(step * item)))];
    }

    /// <param name="preview">Preview of the default; null for none.</param>
    private static async Task<int> CountAsync(CommandContext context, string instruction, int first, GhostFunction? preview) =>
        (int)await context.ValueAsync(new NumberPrompt(instruction) { Default = NumberPrompt.Format(first), Min = 1, Max = MaxItems, IsInteger = true, Preview = preview }).ConfigureAwait(false);
}
