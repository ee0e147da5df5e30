using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Files;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>POLYGON: Draws a regular polygon in or about a circle, or on an edge, as a closed polyline.</summary>
internal sealed class PolygonCommand : ICommand
{
    private const string Sides = "POLYSIDES";
    private const string Fit = "POLYGON";
    private const int MaxSides = 1024;

    public CommandInfo Info { get; } = new("POLYGON", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        NewDrawing.EnsureOpen(context);
        var sides = (int)await context.ValueAsync(new NumberPrompt(Wording.Get("Polygon.EnterSides")) { Default = context.LastValue(Sides, "4"), Min = 3, Max = MaxSides, IsInteger = true }).ConfigureAwait(false);
        context.Remember(Sides, NumberPrompt.Format(sides));
        var outline = await context.AskAsync(ShapePrompts.Place("Polygon.SpecifyCentre", null, "Edge")).ConfigureAwait(false) is Answer<Point2D>.Value { Result: var centre }
            ? await FromCentreAsync(context, centre, sides).ConfigureAwait(false)
            : await FromEdgeAsync(context, sides).ConfigureAwait(false);
        DrawingAddition.Commit(context, NewCurve.Polyline(outline, closed: true));
    }

    private static async Task<IReadOnlyList<Segment>> FromCentreAsync(CommandContext context, Point2D centre, int sides)
    {
        var fit = await context.ChoiceAsync(Wording.Get("Common.EnterOption"), Keyword.List("Inscribed", "Circumscribed"), context.LastValue(Fit, "Inscribed")).ConfigureAwait(false);
        context.Remember(Fit, fit);
        var isInscribed = fit == "Inscribed";
        var level = Angle.FromDegrees(isInscribed ? (180.0 / sides) - 90.0 : -90.0); // The bottom side is horizontal if the radius is typed.
        while (true)
        {
            switch (await context.AskAsync(new DistancePrompt(Wording.Get("Circle.SpecifyRadius"), centre) { Ghost = place => Outline(place) ?? [] }).ConfigureAwait(false))
            {
                case Answer<Amount>.Value { Result: Amount.Number { Value: var radius } } when Outline(centre + Vector2D.FromPolar(radius, level)) is { } outline: return outline;
                case Answer<Amount>.Value { Result: Amount.Number }: context.WriteMessage(Wording.Get("Drafting.Impossible"), MessageKind.Warning); break; // Beyond the precision of such coordinates.
                case Answer<Amount>.Value { Result: Amount.FirstPoint { Point: var place } } when Outline(place) is { } outline: return outline;
            }
        }

        IReadOnlyList<Segment>? Outline(Point2D place) => place == centre ? null : PolygonConstruction.Outline(isInscribed ? PolygonConstruction.Inscribed(centre, place, sides) : PolygonConstruction.Circumscribed(centre, place, sides));
    }

    private static async Task<IReadOnlyList<Segment>> FromEdgeAsync(CommandContext context, int sides)
    {
        var first = await ShapePrompts.PointAsync(context, "Polygon.SpecifyFirstEdge").ConfigureAwait(false);
        var (outline, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Polygon.SpecifySecondEdge", first), second => second == first ? null : PolygonConstruction.Outline(PolygonConstruction.OnEdge(first, second, sides))).ConfigureAwait(false);
        return outline;
    }
}

/// <summary>Asks for a point relative to another one, or for its distance as a number.</summary>
/// <param name="From">Drawing units.</param>
internal sealed record DistancePrompt(string Instruction, Point2D From) : ValuePrompt<Amount>(Instruction)
{
    /// <summary>Preview for a cursor position (<see cref="PointRequest.Ghost"/>).</summary>
    public GhostFunction? Ghost { get; init; }

    public override PointRequest PointRequest => new(PointPurpose.Place, From) { Ghost = Ghost };

    /// <returns>The distance as a number, a point as first point.</returns>
    public override ParsedInput<Amount> Parse(string typed, Point2D lastPoint) =>
        new AmountPrompt(Instruction, way => way.Length) { Min = ShapePrompts.Min, Max = ShapePrompts.Max }.Parse(typed, lastPoint);
}
