using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>STRETCH: Moves the ends and vertices in a crossing box; objects completely in it move completely.</summary>
internal sealed class StretchCommand : ICommand
{
    private const string Last = "STRETCH";

    public CommandInfo Info { get; } = new("STRETCH", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        context.WriteMessage(Wording.Get("Stretch.HowToSelect"));
        var stretch = await SelectAsync(context).ConfigureAwait(false);
        var by = await DisplacementAsync(context, place => stretch.Of(drawing, place).Preview).ConfigureAwait(false);
        var done = stretch.Of(drawing, by);
        if (done.Edited is not { } edited) throw new CommandException(CommandFailure.Usage, Wording.Get("Stretch.InvalidResult"));
        if (done.Unchanged > 0) context.WriteMessage(Wording.Get("Stretch.Unchanged", CountText.Format(done.Unchanged, "Object")));
        DrawingChange.Commit(context, DrawingChange.AnnotationsOf(context, stretch.FullySelected(drawing)).Moved(edited, Transform2D.Move(by)), [.. stretch.Entities]);
    }

    /// <summary>Boxes and single objects until Enter. A box to the left is a crossing box; objects in a box to the right and individually picked objects move
    /// completely.</summary>
    private static async Task<StretchSelection> SelectAsync(CommandContext context)
    {
        var stretch = new StretchSelection(ObjectSelection.WithoutLocked(context, ObjectSelection.CurvesOf(context, context.Document.Current.Selection)));
        var prompt = new PointPrompt(Wording.Get("ObjectSelection.SelectObjects")) { Options = Keyword.List("Crossing", "Undo"), EnterEnds = true, Purpose = PointPurpose.Object };
        while (await context.AskAsync(prompt).ConfigureAwait(false) is var answer and not Answer<Point2D>.EndOfList)
        {
            if (answer is Answer<Point2D>.SelectedOption { Option: "Undo" }) stretch.Undo();
            else if (answer is Answer<Point2D>.Value { Result: var at } && ObjectSelection.EntityAt(context, at) is { } entity) context.WriteMessage(stretch.Add(ObjectSelection.WithoutLocked(context, [entity]), null));
            else context.WriteMessage(await BoxAsync(context, stretch, answer is Answer<Point2D>.Value { Result: var corner } ? corner : null).ConfigureAwait(false));
        }

        return stretch.Entities.Count > 0 ? stretch : throw new CommandException(CommandFailure.Usage, Wording.Get("ObjectSelection.NothingSelected"));
    }

    /// <param name="corner">Null: asked for, and the box is a crossing box in both directions.</param>
    private static async Task<string> BoxAsync(CommandContext context, StretchSelection stretch, Point2D? corner)
    {
        var first = corner ?? await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyFirstCorner")) { Purpose = PointPurpose.Corner }).ConfigureAwait(false);
        var second = await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyOppositeCorner")) { Purpose = PointPurpose.Corner, From = first }).ConfigureAwait(false);
        var box = Bounds2D.FromCorners(first, second);
        return corner is null || second.X < first.X ? stretch.Add(ObjectSelection.WithoutLocked(context, [.. DrawingPick.Touching(context.Drawing, box)]), box) : stretch.Add(ObjectSelection.WithoutLocked(context, [.. DrawingPick.Inside(context.Drawing, box)]), null);
    }

    private static async Task<Vector2D> DisplacementAsync(CommandContext context, Func<Vector2D, IReadOnlyList<Segment>> shown)
    {
        var standard = context.LastValue(Last, "0,0");
        var first = await context.AskAsync(new PointPrompt(Wording.Get("Editing.SpecifyBasePoint")) { Options = Keyword.List("Displacement"), Default = "Displacement" }).ConfigureAwait(false);
        if (first is not Answer<Point2D>.Value { Result: var basePoint })
        {
            var way = await context.ValueAsync(new PointPrompt(Wording.Get("Displacement.SpecifyDisplacement")) { Default = standard }).ConfigureAwait(false) - Point2D.Origin;
            context.Remember(Last, string.Create(CultureInfo.InvariantCulture, $"{way.X:R},{way.Y:R}"));
            return way;
        }

        var prompt = new PointPrompt(Wording.Get("Common.SpecifySecondPointOrDisplacement")) { EnterEnds = true, From = basePoint, Ghost = place => shown(place - basePoint) };
        return await context.AskAsync(prompt).ConfigureAwait(false) is Answer<Point2D>.Value { Result: var second } ? second - basePoint : basePoint - Point2D.Origin;
    }
}
