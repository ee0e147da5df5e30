using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>The prompts for arcs that ARC and PLINE share. Each returns an arc that starts at its start point.</summary>
internal static class ArcPrompts
{
    /// <summary>Start, second point, end.</summary>
    public static async Task<Segment> ThreePointAsync(CommandContext context, Point2D start, Point2D second)
    {
        var (arc, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Arc.SpecifyEnd", second), place => Between(ArcConstruction.ThroughPoints(start, second, place), start, place)).ConfigureAwait(false);
        return arc[0];
    }

    /// <summary>Start and centre: with end point, included angle or chord length. Counter-clockwise unless the angle is negative.</summary>
    public static async Task<Segment> StartCentreAsync(CommandContext context, Point2D start, Point2D centre)
    {
        var prompt = ShapePrompts.Place("Arc.SpecifyEnd", centre, "Angle", "Length");
        var (arc, option) = await ShapePrompts.PlaceAsync(context, prompt, place => Of(ArcConstruction.FromCentreTo(start, centre, place))).ConfigureAwait(false);
        if (option == "Angle") (arc, _) = await ShapePrompts.AmountAsync(context, ShapePrompts.Degrees("Arc.SpecifyAngle", centre), degrees => Of(ArcConstruction.FromCentreSweep(start, centre, Angle.FromDegrees(degrees)))).ConfigureAwait(false);
        else if (option == "Length") (arc, _) = await ShapePrompts.AmountAsync(context, SignedAnglePrompt(context, "Arc.SpecifyChord", start), chord => Of(ArcConstruction.FromCentreChord(start, centre, chord))).ConfigureAwait(false);
        return arc[0];
    }

    /// <summary>Start and end: with centre (counter-clockwise), included angle, direction or radius.</summary>
    public static async Task<Segment> StartEndAsync(CommandContext context, Point2D start, Point2D end)
    {
        var prompt = ShapePrompts.Place("Arc.SpecifyCentre", null, "Angle", "Direction", "Radius");
        var (arc, option) = await ShapePrompts.PlaceAsync(context, prompt, centre => Of(ArcConstruction.FromCentreTo(start, centre, end))).ConfigureAwait(false);
        return option switch
        {
            "Angle" => await StartEndAngleAsync(context, start, end).ConfigureAwait(false),
            "Direction" => await StartEndDirectionAsync(context, start, end).ConfigureAwait(false),
            "Radius" => await StartEndRadiusAsync(context, start, end).ConfigureAwait(false),
            _ => arc[0],
        };
    }

    /// <summary>The arc as a shape; null if there is none.</summary>
    public static IReadOnlyList<Segment>? Of(ArcSegment? arc) => arc is { } one ? [Segment.FromArc(one)] : null;

    /// <summary>The arc as a shape with exactly the given ends; null if there is none.</summary>
    public static IReadOnlyList<Segment>? Between(ArcSegment? arc, Point2D start, Point2D end) => arc is { } one ? [Segment.FromArc(one, start, end)] : null;

    /// <summary>A length; a negative one selects the longer arc.</summary>
    public static AmountPrompt SignedAnglePrompt(CommandContext context, string text, Point2D from) => ShapePrompts.Length(context, text, from) with { Min = -ShapePrompts.Max };

    private static async Task<Segment> StartEndAngleAsync(CommandContext context, Point2D start, Point2D end)
    {
        var (arc, _) = await ShapePrompts.AmountAsync(context, ShapePrompts.Degrees("Arc.SpecifyAngle", start), degrees => Between(ArcConstruction.FromEndsSweep(start, end, Angle.FromDegrees(degrees)), start, end)).ConfigureAwait(false);
        return arc[0];
    }

    private static async Task<Segment> StartEndDirectionAsync(CommandContext context, Point2D start, Point2D end)
    {
        var (arc, _) = await ShapePrompts.AmountAsync(context, ShapePrompts.Degrees("Arc.SpecifyDirection", start), degrees => Between(ArcConstruction.FromEndsDirection(start, end, Vector2D.FromPolar(1.0, Angle.FromDegrees(degrees))), start, end)).ConfigureAwait(false);
        return arc[0];
    }

    private static async Task<Segment> StartEndRadiusAsync(CommandContext context, Point2D start, Point2D end)
    {
        var (arc, _) = await ShapePrompts.AmountAsync(context, SignedAnglePrompt(context, "Arc.SpecifyRadius", end), radius => Between(ArcConstruction.FromEndsRadius(start, end, radius), start, end)).ConfigureAwait(false);
        return arc[0];
    }
}
