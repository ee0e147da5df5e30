using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Files;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>RECTANG: Draws a rectangle as a closed polyline: by two corners, its area or its sides, turned, with corners cut off or rounded.</summary>
internal sealed class RectangleCommand : ICommand
{
    private const string Rotation = "RECTANG.Rotation";
    private const string Length = "RECTANG.Length";
    private const string Width = "RECTANG.Width";
    private const string Area = "RECTANG.Area";
    private const string Basis = "RECTANG.Basis";

    public CommandInfo Info { get; } = new("RECTANG", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        NewDrawing.EnsureOpen(context);
        var cut = RectangleCorners.Remembered(context);
        if (!cut.IsNone) context.WriteMessage(Wording.Get(cut.Radius > 0.0 ? "Rectang.Filleted" : "Rectang.Chamfered", cut.Before, cut.After));
        while (true)
        {
            switch (await context.AskAsync(ShapePrompts.Place("Rectang.SpecifyFirst", null, "Chamfer", "Fillet")).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Result: var corner }:
                    DrawingAddition.Commit(context, NewCurve.Polyline(await ToCornerAsync(context, corner, cut).ConfigureAwait(false), closed: true));
                    return;
                case Answer<Point2D>.SelectedOption { Option: var option }:
                    cut = await RectangleCorners.AskAsync(context, option).ConfigureAwait(false);
                    break;
            }
        }
    }

    private static async Task<IReadOnlyList<Segment>> ToCornerAsync(CommandContext context, Point2D corner, CornerCut cut)
    {
        var turn = RotationOf(context);
        while (true)
        {
            var prompt = ShapePrompts.Place("Rectang.SpecifyOther", null, "Area", "Dimensions", "Rotation"); // No rubber band and no ORTHO: the rectangle itself is shown.
            var (outline, option) = await ShapePrompts.PlaceAsync(context, prompt, place => Outline(corner, PolygonConstruction.SidesOf(corner, place, turn), turn, cut)).ConfigureAwait(false);
            if (option is null) return outline;
            if (option == "Rotation") turn = await RotationAsync(context, corner).ConfigureAwait(false);
            else return await ToQuadrantAsync(context, corner, option == "Area" ? await ByAreaAsync(context).ConfigureAwait(false) : await BySidesAsync(context).ConfigureAwait(false), turn, cut).ConfigureAwait(false);
        }
    }

    /// <summary>The rectangle with two given sides in the picked quadrant.</summary>
    private static async Task<IReadOnlyList<Segment>> ToQuadrantAsync(CommandContext context, Point2D corner, Vector2D sides, Angle turn, CornerCut cut)
    {
        var (outline, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place("Rectang.SpecifyQuadrant"), Quadrant).ConfigureAwait(false);
        return outline;

        IReadOnlyList<Segment>? Quadrant(Point2D place)
        {
            var toward = PolygonConstruction.SidesOf(corner, place, turn);
            return Outline(corner, new Vector2D(Math.CopySign(sides.X, toward.X), Math.CopySign(sides.Y, toward.Y)), turn, cut);
        }
    }

    private static async Task<Vector2D> BySidesAsync(CommandContext context)
    {
        var length = await LengthAsync(context, "Rectang.SpecifyLength", Length, "10").ConfigureAwait(false);
        return new Vector2D(length, await LengthAsync(context, "Rectang.SpecifyWidth", Width, "10").ConfigureAwait(false));
    }

    private static async Task<Vector2D> ByAreaAsync(CommandContext context)
    {
        var area = await LengthAsync(context, "Rectang.EnterArea", Area, "100").ConfigureAwait(false);
        var basis = await context.ChoiceAsync(Wording.Get("Rectang.ChooseBasis"), Keyword.List("Length", "Width"), context.LastValue(Basis, "Length")).ConfigureAwait(false);
        context.Remember(Basis, basis);
        if (basis == "Width" && await LengthAsync(context, "Rectang.SpecifyWidth", Width, "10").ConfigureAwait(false) is var width) return new Vector2D(area / width, width);
        var length = await LengthAsync(context, "Rectang.SpecifyLength", Length, "10").ConfigureAwait(false);
        return new Vector2D(length, area / length);
    }

    private static async Task<Angle> RotationAsync(CommandContext context, Point2D corner)
    {
        var (degrees, option) = await ShapePrompts.NumberAsync(context, ShapePrompts.Degrees("Rectang.SpecifyRotation", corner, context.LastValue(Rotation, "0"), "Pick")).ConfigureAwait(false);
        if (option is not null)
        {
            var first = await ShapePrompts.PointAsync(context, "Rectang.SpecifyFirstPoint").ConfigureAwait(false);
            degrees = (await ShapePrompts.PointAsync(context, "Common.SpecifySecondPoint", first).ConfigureAwait(false) - first).Direction.Degrees;
        }

        context.Remember(Rotation, degrees.ToString("R", CultureInfo.InvariantCulture));
        return Angle.FromDegrees(degrees);
    }

    private static async Task<double> LengthAsync(CommandContext context, string text, string memory, string first)
    {
        var (value, _) = await ShapePrompts.NumberAsync(context, ShapePrompts.Length(context, text, null, memory, first)).ConfigureAwait(false);
        context.Remember(memory, value.ToString("R", CultureInfo.InvariantCulture));
        return value;
    }

    private static Angle RotationOf(CommandContext context) => NumberPrompt.TryParse(context.LastValue(Rotation, "0"), out var degrees) ? Angle.FromDegrees(degrees) : Angle.Zero;

    private static IReadOnlyList<Segment>? Outline(Point2D corner, Vector2D sides, Angle turn, CornerCut cut) =>
        Math.Abs(sides.X) >= ShapePrompts.Min && Math.Abs(sides.Y) >= ShapePrompts.Min ? cut.Apply(PolygonConstruction.Rectangle(corner, sides, turn)) : null;
}

/// <summary>Corner treatment of RECTANG; kept for the next rectangle, as in AutoCAD.</summary>
internal static class RectangleCorners
{
    private const string First = "RECTANG.Chamfer1";
    private const string Second = "RECTANG.Chamfer2";
    private const string Radius = "RECTANG.Fillet";

    public static CornerCut Remembered(CommandContext context) =>
        Value(context, Radius) is > 0.0 and var radius ? CornerCut.FromRadius(radius) : CornerCut.Chamfer(Value(context, First), Value(context, Second));

    /// <param name="option">Chamfer or Fillet; each replaces the other.</param>
    public static async Task<CornerCut> AskAsync(CommandContext context, string option)
    {
        var (first, second, radius) = (0.0, 0.0, 0.0);
        if (option == "Fillet") radius = await DistanceAsync(context, "Rectang.SpecifyFillet", Value(context, Radius)).ConfigureAwait(false);
        else
        {
            first = await DistanceAsync(context, "Rectang.SpecifyFirstChamfer", Value(context, First)).ConfigureAwait(false);
            second = await DistanceAsync(context, "Rectang.SpecifySecondChamfer", Value(context, Second) is > 0.0 and var last ? last : first).ConfigureAwait(false);
        }

        foreach (var (name, value) in new[] { (First, first), (Second, second), (Radius, radius) }) context.Remember(name, value.ToString("R", CultureInfo.InvariantCulture));
        return Remembered(context);
    }

    private static async Task<double> DistanceAsync(CommandContext context, string text, double last)
    {
        var prompt = ShapePrompts.Length(context, text, null, null, NumberPrompt.Format(last)) with { Min = 0.0 };
        return (await ShapePrompts.NumberAsync(context, prompt).ConfigureAwait(false)).Value;
    }

    private static double Value(CommandContext context, string name) => NumberPrompt.TryParse(context.LastValue(name, "0"), out var value) ? value : 0.0;
}
