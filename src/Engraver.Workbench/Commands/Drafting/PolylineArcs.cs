using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>The arcs of PLINE: by default each is tangent to the previous segment.</summary>
internal static class PolylineArcs
{
    private static readonly string[] s_options = ["Angle", "CEnter", "Direction", "Line", "Radius", "Second", "Undo"];
    private static readonly string[] s_withClose = ["Angle", "CEnter", "CLose", "Direction", "Line", "Radius", "Second", "Undo"];

    /// <returns>False if the next segment is a line.</returns>
    public static async Task<bool> NextAsync(CommandContext context, PolylineDraft run)
    {
        var prompt = ShapePrompts.Place("Pline.SpecifyArcEnd", run.End, run.Segments.Count > 0 ? s_withClose : s_options) with { EnterEnds = true };
        var (arc, option) = await ShapePrompts.PlaceAsync(context, prompt, place => Smooth(run, place)).ConfigureAwait(false);
        switch (option)
        {
            case null: run.Add(arc[0]); break;
            case "Line": return false;
            case "CLose": Close(context, run); break;
            case "Undo": run.Undo(context); break;
            case ShapePrompts.Enter: run.Finish(); break;
            default: run.Add(await ByOptionAsync(context, run.End, run.Direction, option).ConfigureAwait(false)); break;
        }

        return true;
    }

    private static IReadOnlyList<Segment>? Smooth(PolylineDraft run, Point2D end) => ArcPrompts.Between(ArcConstruction.FromEndsDirection(run.End, end, run.Direction), run.End, end);

    private static void Close(CommandContext context, PolylineDraft run)
    {
        if (run.End == run.Start) run.Close(null);
        else if (Smooth(run, run.Start) is { } last) run.Close(last);
        else context.WriteMessage(Wording.Get("Drafting.Impossible"), MessageKind.Warning);
    }

    private static Task<Segment> ByOptionAsync(CommandContext context, Point2D start, Vector2D direction, string option) => option switch
    {
        "Angle" => IncludedAngleAsync(context, start),
        "CEnter" => CentreAsync(context, start),
        "Direction" => DirectionAsync(context, start),
        "Radius" => RadiusAsync(context, start, direction),
        _ => SecondPointAsync(context, start),
    };

    private static async Task<Segment> IncludedAngleAsync(CommandContext context, Point2D start)
    {
        var sweep = Angle.FromDegrees(await AngleAsync(context, start).ConfigureAwait(false));
        var prompt = ShapePrompts.Place("Pline.SpecifyArcEnd", start, "CEnter", "Radius");
        var (arc, option) = await ShapePrompts.PlaceAsync(context, prompt, end => ArcPrompts.Between(ArcConstruction.FromEndsSweep(start, end, sweep), start, end)).ConfigureAwait(false);
        if (option == "CEnter") (arc, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Arc.SpecifyCentre", start), centre => ArcPrompts.Of(ArcConstruction.FromCentreSweep(start, centre, sweep))).ConfigureAwait(false);
        if (option == "Radius")
        {
            var (radius, _) = await ShapePrompts.NumberAsync(context, ShapePrompts.Length(context, "Arc.SpecifyRadius", start)).ConfigureAwait(false);
            arc = await AlongChordAsync(context, start, 2.0 * radius * Math.Abs((sweep * 0.5).Sin()), sweep).ConfigureAwait(false);
        }

        return arc[0];
    }

    private static async Task<Segment> CentreAsync(CommandContext context, Point2D start)
    {
        var (spoke, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Arc.SpecifyCentre", start), place => place == start ? null : [Segment.FromLine(start, place)]).ConfigureAwait(false);
        return await ArcPrompts.StartCentreAsync(context, start, spoke[0].End).ConfigureAwait(false);
    }

    private static async Task<Segment> DirectionAsync(CommandContext context, Point2D start)
    {
        var (degrees, _) = await ShapePrompts.NumberAsync(context, ShapePrompts.Degrees("Arc.SpecifyDirection", start)).ConfigureAwait(false);
        var direction = Vector2D.FromPolar(1.0, Angle.FromDegrees(degrees));
        var (arc, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Arc.SpecifyEnd", start), end => ArcPrompts.Between(ArcConstruction.FromEndsDirection(start, end, direction), start, end)).ConfigureAwait(false);
        return arc[0];
    }

    /// <summary>The arc of the two with this radius that continues more smoothly.</summary>
    private static async Task<Segment> RadiusAsync(CommandContext context, Point2D start, Vector2D direction)
    {
        var (radius, _) = await ShapePrompts.NumberAsync(context, ShapePrompts.Length(context, "Arc.SpecifyRadius", start)).ConfigureAwait(false);
        var (arc, option) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Pline.SpecifyArcEnd", start, "Angle"), end => Smoother(start, end, radius, direction)).ConfigureAwait(false);
        if (option is null) return arc[0];
        var sweep = Angle.FromDegrees(await AngleAsync(context, start).ConfigureAwait(false));
        return (await AlongChordAsync(context, start, 2.0 * radius * Math.Abs((sweep * 0.5).Sin()), sweep).ConfigureAwait(false))[0];
    }

    private static IReadOnlyList<Segment>? Smoother(Point2D start, Point2D end, double radius, Vector2D direction)
    {
        if (ArcConstruction.FromEndsRadius(start, end, radius) is not { } left || ArcConstruction.FromEndsSweep(start, end, -left.Sweep) is not { } right) return null;
        return ArcPrompts.Between(left.TangentAt(0.0).Dot(direction) >= right.TangentAt(0.0).Dot(direction) ? left : right, start, end);
    }

    private static async Task<Segment> SecondPointAsync(CommandContext context, Point2D start)
    {
        var (line, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Pline.SpecifySecond", start), place => place == start ? null : [Segment.FromLine(start, place)]).ConfigureAwait(false);
        return await ArcPrompts.ThreePointAsync(context, start, line[0].End).ConfigureAwait(false);
    }

    /// <summary>An included angle of an arc: neither zero nor a full turn.</summary>
    private static async Task<double> AngleAsync(CommandContext context, Point2D start)
    {
        var (arc, _) = await ShapePrompts.AmountAsync(context, ShapePrompts.Degrees("Arc.SpecifyAngle", start), degrees => ArcPrompts.Of(ArcConstruction.FromCentreSweep(start, start + new Vector2D(1.0, 0.0), Angle.FromDegrees(degrees)))).ConfigureAwait(false);
        return arc[0].Arc.Sweep.Degrees;
    }

    private static async Task<IReadOnlyList<Segment>> AlongChordAsync(CommandContext context, Point2D start, double chord, Angle sweep)
    {
        var (arc, _) = await ShapePrompts.AmountAsync(context, ShapePrompts.Degrees("Pline.SpecifyChordDirection", start), degrees => ArcPrompts.Of(ArcConstruction.FromEndsSweep(start, start + Vector2D.FromPolar(chord, Angle.FromDegrees(degrees)), sweep))).ConfigureAwait(false);
        return arc;
    }
}
