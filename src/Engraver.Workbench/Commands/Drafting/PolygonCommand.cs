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
    private const int MostSides = 1024;

    public CommandInfo Info { get; } = new("POLYGON", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        DrawingBeginning.Ensure(context);
        var sides = (int)await context.ValueAsync(new NumberPrompt(Wording.Get("Polygon.EnterSides")) { Default = context.Remembered(Sides, "4"), Least = 3, Most = MostSides, Whole = true }).ConfigureAwait(false);
        context.Remember(Sides, NumberPrompt.Show(sides));
        var outline = await context.AskAsync(ShapePrompts.Place("Polygon.SpecifyCentre", null, "Edge")).ConfigureAwait(false) is Answer<Point2D>.Value { Of: var centre }
            ? await AboutAsync(context, centre, sides).ConfigureAwait(false)
            : await OnEdgeAsync(context, sides).ConfigureAwait(false);
        DrawingAddition.Take(context, NewCurve.Polyline(outline, closed: true));
    }

    private static async Task<IReadOnlyList<Segment>> AboutAsync(CommandContext context, Point2D centre, int sides)
    {
        var fit = await context.ChoiceAsync(Wording.Get("Common.EnterOption"), Keyword.List("Inscribed", "Circumscribed"), context.Remembered(Fit, "Inscribed")).ConfigureAwait(false);
        context.Remember(Fit, fit);
        var isInscribed = fit == "Inscribed";
        var level = Angle.FromDegrees(isInscribed ? (180.0 / sides) - 90.0 : -90.0); // The bottom side is horizontal if the radius is typed.
        while (true)
        {
            switch (await context.AskAsync(new ReachPrompt(Wording.Get("Circle.SpecifyRadius"), centre) { Ghost = place => Outline(place) ?? [] }).ConfigureAwait(false))
            {
                case Answer<Amount>.Value { Of: Amount.Number { Of: var radius } } when Outline(centre + Vector2D.FromPolar(radius, level)) is { } outline: return outline;
                case Answer<Amount>.Value { Of: Amount.Number }: context.Say(Wording.Get("Drafting.Impossible"), MessageKind.Warning); break; // Beyond the precision of such coordinates.
                case Answer<Amount>.Value { Of: Amount.Beginning { At: var place } } when Outline(place) is { } outline: return outline;
            }
        }

        IReadOnlyList<Segment>? Outline(Point2D place) => place == centre ? null : PolygonConstruction.Outline(isInscribed ? PolygonConstruction.Inscribed(centre, place, sides) : PolygonConstruction.Circumscribed(centre, place, sides));
    }

    private static async Task<IReadOnlyList<Segment>> OnEdgeAsync(CommandContext context, int sides)
    {
        var first = await ShapePrompts.PointAsync(context, "Polygon.SpecifyFirstEdge").ConfigureAwait(false);
        var (outline, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Polygon.SpecifySecondEdge", first), second => second == first ? null : PolygonConstruction.Outline(PolygonConstruction.OnEdge(first, second, sides))).ConfigureAwait(false);
        return outline;
    }
}

/// <summary>Asks for a point relative to another one, or for its distance as a number.</summary>
/// <param name="From">Drawing units.</param>
internal sealed record ReachPrompt(string Instruction, Point2D From) : ValuePrompt<Amount>(Instruction)
{
    /// <summary>Preview for a cursor position (<see cref="PointAim.Ghost"/>).</summary>
    public GhostOf? Ghost { get; init; }

    public override PointAim Aim => new(PointUse.Place, From) { Ghost = Ghost };

    /// <returns>The distance as a number, a point as first point.</returns>
    public override Reading<Amount> Read(string typed, Point2D lastPoint) =>
        new AmountPrompt(Instruction, way => way.Length) { Least = ShapePrompts.Least, Most = ShapePrompts.Most }.Read(typed, lastPoint);
}
