using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Constructions;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Files;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>ELLIPSE: Draws an ellipse, or with Arc a part of one, by its axes or as a turned circle.</summary>
internal sealed class EllipseCommand : ICommand
{
    /// <summary>Maximum rotation of a circle about the first axis, degrees, as in AutoCAD.</summary>
    private const double MostRotation = 89.4;

    public CommandInfo Info { get; } = new("ELLIPSE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        DrawingBeginning.Ensure(context);
        var answer = await context.AskAsync(ShapePrompts.Place("Ellipse.SpecifyAxisEnd", null, "Arc", "Center")).ConfigureAwait(false);
        var isArc = answer is Answer<Point2D>.Chosen { Option: "Arc" };
        if (isArc) answer = await context.AskAsync(ShapePrompts.Place("Ellipse.SpecifyAxisEndOfArc", null, "Center")).ConfigureAwait(false);
        var axis = answer is Answer<Point2D>.Value { Of: var end } ? await AcrossAsync(context, end).ConfigureAwait(false) : await FromCentreAsync(context).ConfigureAwait(false);
        var axes = await OtherAxisAsync(context, axis).ConfigureAwait(false);
        var drawn = isArc ? await EllipsePart.AskAsync(context, axes).ConfigureAwait(false) : axes.Part(Angle.Zero, Angle.FullTurn)![0];
        DrawingAddition.Take(context, NewCurve.From(drawn));
    }

    private static async Task<EllipseAxes> AcrossAsync(CommandContext context, Point2D end)
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
        var (line, _) = await ShapePrompts.PlaceAsync(context, ShapePrompts.Place(text, from), place => place.DistanceTo(from) < ShapePrompts.Least ? null : [Segment.FromLine(from, place)]).ConfigureAwait(false);
        return line[0].End;
    }

    private static async Task<EllipseAxes> OtherAxisAsync(CommandContext context, EllipseAxes axis)
    {
        var (half, option) = await ShapePrompts.FittingAsync(context, ShapePrompts.Length(context, "Ellipse.SpecifyDistance", axis.Centre, null, null, "Rotation"), Whole).ConfigureAwait(false);
        if (option is null) return axis with { Second = half };
        var turned = ShapePrompts.Degrees("Ellipse.SpecifyRotation", axis.Centre) with { Least = -MostRotation, Most = MostRotation };
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

/// <summary>Start and end of an elliptical arc: angles to the first axis, or parameters.</summary>
internal static class EllipsePart
{
    public static async Task<Segment> AskAsync(CommandContext context, EllipseAxes axes)
    {
        var (start, isParameter) = await StartAsync(context, axes).ConfigureAwait(false);
        while (true)
        {
            string[] options = [isParameter ? "Angle" : "Parameter", "Included"];
            var prompt = Angles(axes, isParameter ? "Ellipse.SpecifyEndParameter" : "Ellipse.SpecifyEndAngle", options);
            var isNow = isParameter;
            var (part, option) = await ShapePrompts.AmountAsync(context, prompt, degrees => Part(axes, start, isNow ? Angle.FromDegrees(degrees) : axes.ParameterAt(degrees))).ConfigureAwait(false);
            if (option == "Included")
            {
                var from = Seen(axes, start);
                (part, option) = await ShapePrompts.AmountAsync(context, Angles(axes, "Arc.SpecifyAngle", []), degrees => Part(axes, start, axes.ParameterAt(from + degrees))).ConfigureAwait(false);
            }

            if (option is null) return part[0];
            isParameter = !isParameter;
        }
    }

    private static async Task<(Angle Start, bool IsParameter)> StartAsync(CommandContext context, EllipseAxes axes)
    {
        for (var isParameter = false; ; isParameter = !isParameter)
        {
            var prompt = Angles(axes, isParameter ? "Ellipse.SpecifyStartParameter" : "Ellipse.SpecifyStartAngle", [isParameter ? "Angle" : "Parameter"]);
            var (degrees, option) = await ShapePrompts.NumberAsync(context, prompt).ConfigureAwait(false);
            if (option is null) return (isParameter ? Angle.FromDegrees(degrees).Positive() : axes.ParameterAt(degrees), isParameter);
        }
    }

    /// <summary>Counter-clockwise from one parameter to another; equal parameters give the whole ellipse.</summary>
    private static IReadOnlyList<Segment>? Part(EllipseAxes axes, Angle start, Angle end)
    {
        var sweep = (end - start).Positive();
        return axes.Part(start, sweep.Degrees == 0.0 ? Angle.FullTurn : sweep);
    }

    /// <summary>The angle of the point of a parameter to the first axis, degrees.</summary>
    private static double Seen(EllipseAxes axes, Angle parameter) => Angle.Direction(axes.First.Length * parameter.Cos(), axes.Second * parameter.Sin()).Degrees;

    /// <summary>An angle to the first axis, typed or given by a point.</summary>
    private static AmountPrompt Angles(EllipseAxes axes, string text, ReadOnlySpan<string> options) =>
        ShapePrompts.Degrees(text, axes.Centre, null, options) with { Measure = way => axes.First.TurnTo(way).Positive().Degrees };
}
