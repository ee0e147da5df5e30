using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>Prompts whose answer completes a shape: the shape is previewed at the cursor, and the prompt is repeated for a point or amount that gives no
/// shape.</summary>
internal static class ShapePrompts
{
    /// <summary>Minimum length, drawing units.</summary>
    public const double Min = 1e-9;

    /// <summary>Maximum length, drawing units.</summary>
    public const double Max = 1e9;

    /// <summary>Represents Enter alone as an answer.</summary>
    public const string Enter = "";

    /// <param name="make">Returns the shape for a point, drawing units; null if there is none. Must not change state.</param>
    /// <returns>The shape, or the chosen option.</returns>
    public static async Task<(IReadOnlyList<Segment> Shape, string? Option)> PlaceAsync(CommandContext context, PointPrompt prompt, Func<Point2D, IReadOnlyList<Segment>?> make)
    {
        var asked = prompt with { Ghost = place => make(place) ?? [] };
        while (true)
        {
            switch (await context.AskAsync(asked).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Result: var place }:
                    if (make(place) is { } shape) return (shape, null);
                    WriteImpossible(context);
                    break;
                case Answer<Point2D>.SelectedOption { Option: var option }:
                    return ([], option);
                default:
                    return ([], Enter);
            }
        }
    }

    /// <param name="make">Returns the shape for an amount; null if there is none. Must not change state.</param>
    /// <param name="memory">Name under which the amount is remembered as next default; null for none.</param>
    /// <returns>The shape, or the chosen option.</returns>
    public static async Task<(IReadOnlyList<Segment> Shape, string? Option)> AmountAsync(CommandContext context, AmountPrompt prompt, Func<double, IReadOnlyList<Segment>?> make, string? memory = null)
    {
        var (value, option) = await FittingAsync(context, prompt, make).ConfigureAwait(false);
        if (option is not null) return ([], option);
        if (memory is not null) context.Remember(memory, value.ToString("R", CultureInfo.InvariantCulture));
        return (make(value)!, null);
    }

    /// <summary>An amount that gives a shape; repeats the prompt until it does.</summary>
    /// <returns>The amount, or the chosen option.</returns>
    public static async Task<(double Value, string? Option)> FittingAsync(CommandContext context, AmountPrompt prompt, Func<double, IReadOnlyList<Segment>?> make)
    {
        while (true)
        {
            var (value, option) = await NumberAsync(context, prompt, make).ConfigureAwait(false);
            if (option is not null || make(value) is not null) return (value, option);
            WriteImpossible(context);
        }
    }

    /// <summary>An amount; after the first point of a vector asks for the second one.</summary>
    /// <param name="make">Returns the preview; null for none.</param>
    /// <returns>The amount, or the chosen option.</returns>
    public static async Task<(double Value, string? Option)> NumberAsync(CommandContext context, AmountPrompt prompt, Func<double, IReadOnlyList<Segment>?>? make = null)
    {
        while (true)
        {
            switch (await context.AskAsync(prompt with { Ghost = GhostOf(prompt, make) }).ConfigureAwait(false))
            {
                case Answer<Amount>.Value { Result: Amount.Number { Value: var value } }:
                    return (value, null);
                case Answer<Amount>.Value { Result: Amount.FirstPoint { Point: var place } }:
                    prompt = prompt with { Instruction = Wording.Get("Common.SpecifySecondPoint"), Options = [], Default = null, From = place };
                    break;
                case Answer<Amount>.SelectedOption { Option: var option }:
                    return (0.0, option);
                default:
                    return (0.0, Enter);
            }
        }
    }

    /// <summary>A length above 0.</summary>
    /// <param name="from">First point; null to ask for two points.</param>
    /// <param name="memory">Name of the remembered default; null for none.</param>
    public static AmountPrompt Length(CommandContext context, string text, Point2D? from, string? memory = null, string? first = null, params ReadOnlySpan<string> options) =>
        new(Wording.Get(text), way => way.Length) { Min = Min, Max = Max, From = from, Default = memory is null ? first : context.LastValue(memory) ?? first, Options = Keyword.List(options) };

    /// <summary>An angle in degrees, counter-clockwise positive; given by a point, the angle of the line to it.</summary>
    public static AmountPrompt Degrees(string text, Point2D? from, string? standard = null, params ReadOnlySpan<string> options) =>
        new(Wording.Get(text), way => way.Direction.Positive().Degrees) { Min = -360.0, Max = 360.0, From = from, Default = standard, Options = Keyword.List(options) };

    public static PointPrompt Place(string text, Point2D? from = null, params ReadOnlySpan<string> options) => new(Wording.Get(text)) { From = from, Options = Keyword.List(options) };

    /// <summary>A point without a base point.</summary>
    public static Task<Point2D> PointAsync(CommandContext context, string text, Point2D? from = null) => context.ValueAsync(Place(text, from));

    private static void WriteImpossible(CommandContext context) => context.WriteMessage(Wording.Get("Drafting.Impossible"), MessageKind.Warning);

    private static GhostFunction? GhostOf(AmountPrompt prompt, Func<double, IReadOnlyList<Segment>?>? make) =>
        make is null || prompt.From is not { } from ? null : place => prompt.Measure(place - from) is var value && value >= prompt.Min && value <= prompt.Max ? make(value) ?? [] : [];
}
