using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>Questions whose answer completes a shape: the shape is seen at the cursor beforehand, and a place or an amount of which none can be made is
/// asked for again.</summary>
internal static class ShapePrompts
{
    /// <summary>Shortest length that is drawn, drawing units.</summary>
    public const double Least = 1e-9;

    /// <summary>Longest length that is drawn, drawing units.</summary>
    public const double Most = 1e9;

    /// <summary>Stands for Enter alone where that is an answer.</summary>
    public const string Enter = "";

    /// <param name="make">The shape of a place, drawing units; null where there is none. It must not change anything.</param>
    /// <returns>The shape; or nothing and the option that was chosen.</returns>
    public static async Task<(IReadOnlyList<Segment> Shape, string? Option)> PlaceAsync(CommandContext context, PointPrompt prompt, Func<Point2D, IReadOnlyList<Segment>?> make)
    {
        var asked = prompt with { Ghost = place => make(place) ?? [] };
        while (true)
        {
            switch (await context.AskAsync(asked).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Of: var place }:
                    if (make(place) is { } shape) return (shape, null);
                    SayImpossible(context);
                    break;
                case Answer<Point2D>.Chosen { Option: var option }:
                    return ([], option);
                default:
                    return ([], Enter);
            }
        }
    }

    /// <param name="make">The shape of an amount; null where there is none. It must not change anything.</param>
    /// <param name="memory">Under which the amount is kept for the next default; null for not.</param>
    /// <returns>The shape; or nothing and the option that was chosen.</returns>
    public static async Task<(IReadOnlyList<Segment> Shape, string? Option)> AmountAsync(CommandContext context, AmountPrompt prompt, Func<double, IReadOnlyList<Segment>?> make, string? memory = null)
    {
        var (value, option) = await FittingAsync(context, prompt, make).ConfigureAwait(false);
        if (option is not null) return ([], option);
        if (memory is not null) context.Remember(memory, value.ToString("R", CultureInfo.InvariantCulture));
        return (make(value)!, null);
    }

    /// <summary>An amount of which there is a shape; asked for until there is one.</summary>
    /// <returns>The amount, or the option that was chosen.</returns>
    public static async Task<(double Value, string? Option)> FittingAsync(CommandContext context, AmountPrompt prompt, Func<double, IReadOnlyList<Segment>?> make)
    {
        while (true)
        {
            var (value, option) = await NumberAsync(context, prompt, make).ConfigureAwait(false);
            if (option is not null || make(value) is not null) return (value, option);
            SayImpossible(context);
        }
    }

    /// <summary>An amount; of a vector whose first point was given, the second point is asked for.</summary>
    /// <param name="make">What would be drawn, for the ghost; null for nothing.</param>
    /// <returns>The amount, or the option that was chosen.</returns>
    public static async Task<(double Value, string? Option)> NumberAsync(CommandContext context, AmountPrompt prompt, Func<double, IReadOnlyList<Segment>?>? make = null)
    {
        while (true)
        {
            switch (await context.AskAsync(prompt with { Ghost = GhostOf(prompt, make) }).ConfigureAwait(false))
            {
                case Answer<Amount>.Value { Of: Amount.Number { Of: var value } }:
                    return (value, null);
                case Answer<Amount>.Value { Of: Amount.Beginning { At: var place } }:
                    prompt = prompt with { Instruction = Wording.Get("Common.SpecifySecondPoint"), Options = [], Default = null, From = place };
                    break;
                case Answer<Amount>.Chosen { Option: var option }:
                    return (0.0, option);
                default:
                    return (0.0, Enter);
            }
        }
    }

    /// <summary>A length above 0.</summary>
    /// <param name="from">Where a second point is measured from; null when two are asked for.</param>
    /// <param name="memory">Of the default; null for none.</param>
    public static AmountPrompt Length(CommandContext context, string text, Point2D? from, string? memory = null, string? first = null, params ReadOnlySpan<string> options) =>
        new(Wording.Get(text), way => way.Length) { Least = Least, Most = Most, From = from, Default = memory is null ? first : context.Remembered(memory) ?? first, Options = Keyword.List(options) };

    /// <summary>An angle in degrees, counter-clockwise positive; shown by a point, that of the line to it.</summary>
    public static AmountPrompt Degrees(string text, Point2D? from, string? standard = null, params ReadOnlySpan<string> options) =>
        new(Wording.Get(text), way => way.Direction.Positive().Degrees) { Least = -360.0, Most = 360.0, From = from, Default = standard, Options = Keyword.List(options) };

    public static PointPrompt Place(string text, Point2D? from = null, params ReadOnlySpan<string> options) => new(Wording.Get(text)) { From = from, Options = Keyword.List(options) };

    /// <summary>A place that stands alone.</summary>
    public static Task<Point2D> PointAsync(CommandContext context, string text, Point2D? from = null) => context.ValueAsync(Place(text, from));

    private static void SayImpossible(CommandContext context) => context.Say(Wording.Get("Drafting.Impossible"), MessageKind.Warning);

    private static GhostOf? GhostOf(AmountPrompt prompt, Func<double, IReadOnlyList<Segment>?>? make) =>
        make is null || prompt.From is not { } from ? null : place => prompt.Measure(place - from) is var value && value >= prompt.Least && value <= prompt.Most ? make(value) ?? [] : [];
}
