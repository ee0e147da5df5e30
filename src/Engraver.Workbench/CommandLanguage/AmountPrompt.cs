using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for an amount between two limits (both allowed): typed as a number, or measured as distance or angle between two points, each entered as in a
/// <see cref="PointPrompt"/>.</summary>
/// <param name="Measure">Turns the vector from the first point to the second, drawing units, into the amount.</param>
public sealed record AmountPrompt(string Instruction, Func<Vector2D, double> Measure) : ValuePrompt<Amount>(Instruction)
{
    public required double Min { get; init; }

    public required double Max { get; init; }

    /// <summary>First point of the measured vector, drawing units; null: the entered point is the first one, and the second is asked next.</summary>
    public Point2D? From { get; init; }

    /// <summary>Preview for a cursor position (<see cref="PointRequest.Ghost"/>).</summary>
    public GhostFunction? Ghost { get; init; }

    public override PointRequest PointRequest => new(PointPurpose.Place, From) { Ghost = Ghost };

    public override ParsedInput<Amount> Parse(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        if (NumberPrompt.TryParse(typed, out _)) return Within(typed);
        if (new PointPrompt(Instruction).Parse(typed, lastPoint) is not ParsedInput<Point2D>.Value { Result: var place }) return new ParsedInput<Amount>.Invalid(Wording.Get("AmountPrompt.NotANumberOrPoint", typed));
        return From is { } from ? Within(Measure(place - from).ToString("R", CultureInfo.InvariantCulture)) : new ParsedInput<Amount>.Value(new Amount.FirstPoint(place));
    }

    private ParsedInput<Amount> Within(string number) => new NumberPrompt(Instruction) { Min = Min, Max = Max }.Parse(number, default) switch
    {
        ParsedInput<double>.Value value => new ParsedInput<Amount>.Value(new Amount.Number(value.Result)),
        ParsedInput<double>.Invalid wrong => new ParsedInput<Amount>.Invalid(wrong.Message),
        _ => throw new System.Diagnostics.UnreachableException(),
    };
}
