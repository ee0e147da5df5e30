using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Files;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>CIRCLE: Draws a circle: centre and radius or diameter, three points, two points, or touching two objects.</summary>
internal sealed class CircleCommand : ICommand
{
    /// <summary>Name of the last radius, as in AutoCAD.</summary>
    private const string Radius = "CIRCLERAD";

    public CommandInfo Info { get; } = new("CIRCLE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        NewDrawing.EnsureOpen(context);
        var circle = await context.AskAsync(ShapePrompts.Place("Circle.SpecifyCentre", null, "3P", "2P", "Ttr")).ConfigureAwait(false) switch
        {
            Answer<Point2D>.Value { Result: var centre } => await CentreAsync(context, centre).ConfigureAwait(false),
            Answer<Point2D>.SelectedOption { Option: "3P" } => await ThreePointAsync(context).ConfigureAwait(false),
            Answer<Point2D>.SelectedOption { Option: "2P" } => await TwoPointAsync(context).ConfigureAwait(false),
            _ => await TangentTangentRadiusAsync(context).ConfigureAwait(false),
        };
        DrawingAddition.Commit(context, NewCurve.From(circle[0]));
    }

    private static async Task<IReadOnlyList<Segment>> CentreAsync(CommandContext context, Point2D centre)
    {
        var (circle, option) = await ShapePrompts.AmountAsync(context, ShapePrompts.Length(context, "Circle.SpecifyRadius", centre, Radius, null, "Diameter"), OfRadius, Radius).ConfigureAwait(false);
        if (option is null) return circle;
        var last = context.LastValue(Radius) is { } radius && NumberPrompt.TryParse(radius, out var half) ? NumberPrompt.Format(2.0 * half) : null;
        (circle, _) = await ShapePrompts.AmountAsync(context, ShapePrompts.Length(context, "Circle.SpecifyDiameter", centre, null, last), diameter => OfRadius(diameter / 2.0)).ConfigureAwait(false);
        context.Remember(Radius, circle[0].Arc.Radius.ToString("R", System.Globalization.CultureInfo.InvariantCulture));
        return circle;

        IReadOnlyList<Segment>? OfRadius(double value) => ArcPrompts.Of(CircleConstruction.FromRadius(centre, value));
    }

    private static async Task<IReadOnlyList<Segment>> ThreePointAsync(CommandContext context)
    {
        var first = await ShapePrompts.PointAsync(context, "Circle.SpecifyFirst").ConfigureAwait(false);
        var second = await ShapePrompts.PointAsync(context, "Circle.SpecifySecond", first).ConfigureAwait(false);
        var (circle, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Circle.SpecifyThird", second), third => ArcPrompts.Of(CircleConstruction.ThroughPoints(first, second, third))).ConfigureAwait(false);
        return circle;
    }

    private static async Task<IReadOnlyList<Segment>> TwoPointAsync(CommandContext context)
    {
        var first = await ShapePrompts.PointAsync(context, "Circle.SpecifyFirstEnd").ConfigureAwait(false);
        var (circle, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Circle.SpecifySecondEnd", first), second => ArcPrompts.Of(CircleConstruction.FromDiameter(first, second))).ConfigureAwait(false);
        return circle;
    }

    private static async Task<IReadOnlyList<Segment>> TangentTangentRadiusAsync(CommandContext context)
    {
        var first = await TangentAsync(context, "Circle.SpecifyFirstTangent").ConfigureAwait(false);
        var second = await TangentAsync(context, "Circle.SpecifySecondTangent").ConfigureAwait(false);
        var (circle, _) = await ShapePrompts.AmountAsync(context, ShapePrompts.Length(context, "Circle.SpecifyRadius", null, Radius), radius => ArcPrompts.Of(CircleConstruction.TangentTo(first, second, radius)), Radius).ConfigureAwait(false);
        return circle;
    }

    /// <summary>The line, arc or circle at a point; repeats the prompt until one is found.</summary>
    private static async Task<(Segment Of, Point2D At)> TangentAsync(CommandContext context, string text)
    {
        while (true)
        {
            var place = await context.ValueAsync(new PointPrompt(Wording.Get(text)) { Purpose = PointPurpose.Object }).ConfigureAwait(false);
            if (ObjectSelection.EntityAt(context, place) is not { } entity) context.WriteMessage(Wording.Get("Offset.NoObjectAtPoint"));
            else if (Core.Drawings.DrawingPick.Segments(context.Drawing, entity).MinBy(segment => segment.DistanceTo(place)) is { IsFreeCurve: false } segment) return (segment, place);
            else context.WriteMessage(Wording.Get("Circle.NoTangent"));
        }
    }
}
