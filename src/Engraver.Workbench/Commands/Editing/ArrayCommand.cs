using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>ARRAY: Copies objects in rows and columns, or around a point.</summary>
internal sealed class ArrayCommand : ICommand
{
    private const int Most = 1000;

    public CommandInfo Info { get; } = new("ARRAY", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.TakeAsync(context).ConfigureAwait(false);
        var type = await context.ChoiceAsync(Wording.Get("Array.EnterArrayType"), Keyword.List("Rectangular", "POlar"), context.Remembered("ARRAY", "Rectangular")).ConfigureAwait(false);
        context.Remember("ARRAY", type);
        var maps = type == "Rectangular" ? await RectangularAsync(context).ConfigureAwait(false) : await PolarAsync(context).ConfigureAwait(false);
        var (drawing, edited) = (context.Drawing, context.Drawing);
        foreach (var map in maps)
        {
            cancellation.ThrowIfCancellationRequested();
            if (!DrawingEdit.TryCopy(edited, selected, map, out edited)) throw new CommandException(CommandFailure.Usage, Wording.Get("Array.CannotCopiedSoOut"));
        }

        var along = DrawingChange.TextsAlong(context, selected);
        DrawingChange.Take(context, edited with { Texts = EditedTexts.Copied(drawing, along, maps) }, selected);
    }

    private static async Task<IReadOnlyList<Transform2D>> RectangularAsync(CommandContext context)
    {
        var rows = await CountAsync(context, Wording.Get("Array.EnterNumberRows"), 3).ConfigureAwait(false);
        var columns = await CountAsync(context, Wording.Get("Array.EnterNumberColumns"), 4).ConfigureAwait(false);
        if (rows * columns > Most) throw new CommandException(CommandFailure.Usage, Wording.Get("Array.CopiesMoreThan", rows * columns, Most));
        var up = rows > 1 ? await context.ValueAsync(new NumberPrompt(Wording.Get("Array.EnterDistanceBetweenRows"))).ConfigureAwait(false) : 0.0;
        var across = columns > 1 ? await context.ValueAsync(new NumberPrompt(Wording.Get("Array.EnterDistanceBetweenColumns"))).ConfigureAwait(false) : 0.0;
        return [.. from row in Enumerable.Range(0, rows) from column in Enumerable.Range(0, columns) where row + column > 0 select Transform2D.Move(new Vector2D(column * across, row * up))];
    }

    private static async Task<IReadOnlyList<Transform2D>> PolarAsync(CommandContext context)
    {
        var centre = await context.ValueAsync(new PointPrompt(Wording.Get("Array.SpecifyCenterPointArray"))).ConfigureAwait(false);
        var items = await CountAsync(context, Wording.Get("Array.EnterNumberItems"), 6).ConfigureAwait(false);
        var fill = await context.ValueAsync(new NumberPrompt(Wording.Get("Array.SpecifyAngleFill")) { Default = "360", Least = -360, Most = 360 }).ConfigureAwait(false);
        var step = Math.Abs(fill) == 360.0 ? fill / items : fill / Math.Max(1, items - 1);
        return [.. Enumerable.Range(1, items - 1).Select(item => Transform2D.Rotate(centre, Angle.FromDegrees(step * item)))];
    }

    private static async Task<int> CountAsync(CommandContext context, string instruction, int first) =>
        (int)await context.ValueAsync(new NumberPrompt(instruction) { Default = NumberPrompt.Show(first), Least = 1, Most = Most, Whole = true }).ConfigureAwait(false);
}
