using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Files;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>ARC: Draws an arc through three points, about a centre, or between two ends; Enter at the first prompt continues tangentially from the last line or
/// arc.</summary>
internal sealed class ArcCommand : ICommand
{
    public CommandInfo Info { get; } = new("ARC", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        NewDrawing.EnsureOpen(context);
        var prompt = ShapePrompts.Place("Arc.SpecifyStart", null, "Center") with { EnterEnds = true };
        var arc = await context.AskAsync(prompt).ConfigureAwait(false) switch
        {
            Answer<Point2D>.Value { Result: var start } => await FromStartAsync(context, start).ConfigureAwait(false),
            Answer<Point2D>.SelectedOption => await FromCentreAsync(context).ConfigureAwait(false),
            _ => await ContinueAsync(context).ConfigureAwait(false),
        };
        DrawingAddition.Commit(context, NewCurve.From(arc));
        context.LastPoint = arc.End;
    }

    private static async Task<Segment> FromStartAsync(CommandContext context, Point2D start)
    {
        var prompt = ShapePrompts.Place("Arc.SpecifySecond", start, "Center", "End");
        var (toSecond, option) = await ShapePrompts.PlaceAsync(context, prompt, place => place == start ? null : [Segment.FromLine(start, place)]).ConfigureAwait(false);
        if (option is null) return await ArcPrompts.ThreePointAsync(context, start, toSecond[0].End).ConfigureAwait(false);
        if (option == "End") return await ArcPrompts.StartEndAsync(context, start, await NextPointAsync(context, "Arc.SpecifyEnd", start).ConfigureAwait(false)).ConfigureAwait(false);
        return await ArcPrompts.StartCentreAsync(context, start, await NextPointAsync(context, "Arc.SpecifyCentre", start).ConfigureAwait(false)).ConfigureAwait(false);
    }

    private static async Task<Segment> FromCentreAsync(CommandContext context)
    {
        var centre = await ShapePrompts.PointAsync(context, "Arc.SpecifyCentre").ConfigureAwait(false);
        return await ArcPrompts.StartCentreAsync(context, await NextPointAsync(context, "Arc.SpecifyStart", centre).ConfigureAwait(false), centre).ConfigureAwait(false);
    }

    /// <exception cref="CommandException">There is no line or arc.</exception>
    private static async Task<Segment> ContinueAsync(CommandContext context)
    {
        if (LastDrawn.In(context) is not { } last) throw new CommandException(CommandFailure.Usage, Wording.Get("Drafting.NothingToContinue"));
        context.LastPoint = last.End;
        var (arc, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Arc.SpecifyEnd", last.End), place => ArcPrompts.Between(ArcConstruction.FromEndsDirection(last.End, place, last.EndTangent), last.End, place)).ConfigureAwait(false);
        return arc[0];
    }

    /// <summary>A point different from the previous one.</summary>
    private static async Task<Point2D> NextPointAsync(CommandContext context, string text, Point2D from)
    {
        var (line, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place(text, from), place => place == from ? null : [Segment.FromLine(from, place)]).ConfigureAwait(false);
        return line[0].End;
    }
}
