using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Files;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>ELLIPSE: Draws an ellipse, or with Arc a part of one, by its axes or as a turned circle.</summary>
internal sealed class EllipseCommand : ICommand
{
    /// <summary>Maximum rotation of a circle about the first axis, degrees, as in AutoCAD.</summary>
    private const double MaxRotation = 89.4;

    public CommandInfo Info { get; } = new("ELLIPSE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        NewDrawing.EnsureOpen(context);
        var answer = await context.AskAsync(ShapePrompts.Place("Ellipse.SpecifyAxisEnd", null, "Arc", "Center")).ConfigureAwait(false);
        var isArc = answer is Answer<Point2D>.SelectedOption { Option: "Arc" };
        if (isArc) answer = await context.AskAsync(ShapePrompts.Place("Ellipse.SpecifyAxisEndOfArc", null, "Center")).ConfigureAwait(false);
        var axis = answer is Answer<Point2D>.Value { Result: var end } ? await AxisEndAsync(context, end).ConfigureAwait(false) : await FromCentreAsync(context).ConfigureAwait(false);
        var axes = await OtherAxisAsync(context, axis).ConfigureAwait(false);
        var drawn = isArc ? await EllipsePart.AskAsync(context, axes).ConfigureAwait(false) : axes.Part(Angle.Zero, Angle.FullTurn)![0];
        DrawingAddition.Commit(context, NewCurve.From(drawn));
    }

    private static async Task<EllipseAxes> AxisEndAsync(CommandContext context, Point2D end)
    {
        var half = (await OtherEndAsync(context, "Ellipse.SpecifyOtherEnd", end).ConfigureAwait(false) - end) * 0.5;
        return new EllipseAxes(end + half, -half, 0.0);
    }

    private static async Task<EllipseAxes> FromCentreAsync(CommandContext context)
    {
        var centre = await ShapePrompts.PointAsync(context, "Ellipse.SpecifyCentre").ConfigureAwait(false);
        return new EllipseAxes(centre, await OtherEndAsync(context, "Ellipse.SpecifyEndOfAxis", centre).ConfigureAwait(false) - centre, 0.0);
    }

    private static async Task<Point2D> OtherEndAsync(CommandContext context, string text, Point2D from)
    {
        var (line, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place(text, from), place => place.DistanceTo(from) < ShapePrompts.Min ? null : [Segment.FromLine(from, place)]).ConfigureAwait(false);
        return line[0].End;
    }

    private static async Task<EllipseAxes> OtherAxisAsync(CommandContext context, EllipseAxes axis)
    {
        var (half, option) = await ShapePrompts.FittingAsync(context, ShapePrompts.Length(context, "Ellipse.SpecifyDistance", axis.Centre, null, null, "Rotation"), Whole).ConfigureAwait(false);
        if (option is null) return axis with { Second = half };
        var turned = ShapePrompts.Degrees("Ellipse.SpecifyRotation", axis.Centre) with { Min = -MaxRotation, Max = MaxRotation };
        var (degrees, _) = await ShapePrompts.FittingAsync(context, turned, value => Whole(Turned(value))).ConfigureAwait(false);
        return axis with { Second = Turned(degrees) };

        double Turned(double value) => EllipseConstruction.Turned(axis.First.Length, Angle.FromDegrees(value));

        IReadOnlyList<Segment>? Whole(double second) => (axis with { Second = second }).Part(Angle.Zero, Angle.FullTurn);
    }
}

/// <summary>Centre, first semi-axis, and length of the second semi-axis.</summary>
internal sealed record EllipseAxes(Point2D Centre, Vector2D First, double Second)
{
    /// <summary>The ellipse or a part of it as drawn: with equal axes a circle or an arc. Null if there is none.</summary>
    public IReadOnlyList<Segment>? Part(Angle start, Angle sweep) => EllipseConstruction.FromAxes(Centre, First, Second, start, sweep) is { } ellipse
        ? [ellipse.IsCircular ? Segment.FromArc(ellipse.ToArc()) : Segment.FromCurve(ellipse.ToCurve())]
        : null;

    /// <summary>The parameter of the point at this angle to the first axis.</summary>
    public Angle ParameterAt(double degrees) => EllipseConstruction.ParameterAt(Angle.FromDegrees(degrees), First.Length, Second);
}
