using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for an amount between two limits (both allowed): typed as a number, or measured as distance or angle between two points, each entered as in a
/// <see cref="PointPrompt"/>.</summary>
/// <param name="Measure">Turns the vector from the first point to the second, drawing units, into the amount.</param>
public sealed record AmountPrompt(string Instruction, Func<Vector2D, double> Measure) : ValuePrompt<Amount>(Instruction)
{
    public required double Least { get; init; }

    public required double Most { get; init; }

    /// <summary>First point of the measured vector, drawing units; null: the entered point is the first one, and the second is asked next.</summary>
    public Point2D? From { get; init; }

    /// <summary>Preview for a cursor position (<see cref="PointAim.Ghost"/>).</summary>
    public GhostOf? Ghost { get; init; }

    public override PointAim Aim => new(PointUse.Place, From) { Ghost = Ghost };

    public override Reading<Amount> Read(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        if (NumberPrompt.TryNumber(typed, out _)) return Within(typed);
        if (new PointPrompt(Instruction).Read(typed, lastPoint) is not Reading<Point2D>.Value { Of: var place }) return new Reading<Amount>.Wrong(Wording.Get("AmountPrompt.NotANumberOrPoint", typed));
        return From is { } from ? Within(Measure(place - from).ToString("R", CultureInfo.InvariantCulture)) : new Reading<Amount>.Value(new Amount.Beginning(place));
    }

    private Reading<Amount> Within(string number) => new NumberPrompt(Instruction) { Least = Least, Most = Most }.Read(number, default) switch
    {
        Reading<double>.Value value => new Reading<Amount>.Value(new Amount.Number(value.Of)),
        Reading<double>.Wrong wrong => new Reading<Amount>.Wrong(wrong.Sentence),
        _ => throw new System.Diagnostics.UnreachableException(),
    };
}

/// <summary>The answer to the prompt.</summary>
public abstract record Amount
{
    private Amount()
    {
    }

    /// <summary>In the unit of the prompt: degrees, a length in drawing units, a factor.</summary>
    public sealed record Number(double Of) : Amount;

    /// <summary>The first point of the measured vector, drawing units.</summary>
    public sealed record Beginning(Point2D At) : Amount;
}
