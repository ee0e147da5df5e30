using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Drafting;

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
                var from = ApparentAngle(axes, start);
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
    private static double ApparentAngle(EllipseAxes axes, Angle parameter) => Angle.Direction(axes.First.Length * parameter.Cos(), axes.Second * parameter.Sin()).Degrees;

    /// <summary>An angle to the first axis, typed or given by a point.</summary>
    private static AmountPrompt Angles(EllipseAxes axes, string text, ReadOnlySpan<string> options) =>
        ShapePrompts.Degrees(text, axes.Centre, null, options) with { Measure = way => axes.First.TurnTo(way).Positive().Degrees };
}
