using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for the direction of a jog: a step <c>x,y</c> in mm, or the name and sign of an axis (<c>X+</c>).</summary>
/// <param name="HasZ">The machine has a Z axis.</param>
internal sealed record JogStepPrompt(string Instruction, bool HasZ) : ValuePrompt<JogStep>(Instruction)
{
    public override ParsedInput<JogStep> Parse(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var parts = typed.Split(',');
        if (parts.Length == 2 && NumberPrompt.TryParse(parts[0], out var x) && NumberPrompt.TryParse(parts[1], out var y)) return new ParsedInput<JogStep>.Value(new JogStep(new Vector2D(x, y), 0.0, HasDistance: true));
        return Direction(typed) is { } way ? new ParsedInput<JogStep>.Value(way) : new ParsedInput<JogStep>.Invalid(Wording.Get("CncJog.NotAStep", typed));
    }

    private JogStep? Direction(string typed) => typed.ToUpperInvariant() switch
    {
        "X+" => new JogStep(new Vector2D(1, 0), 0.0, HasDistance: false),
        "X-" => new JogStep(new Vector2D(-1, 0), 0.0, HasDistance: false),
        "Y+" => new JogStep(new Vector2D(0, 1), 0.0, HasDistance: false),
        "Y-" => new JogStep(new Vector2D(0, -1), 0.0, HasDistance: false),
        "Z+" when HasZ => new JogStep(default, 1.0, HasDistance: false),
        "Z-" when HasZ => new JogStep(default, -1.0, HasDistance: false),
        _ => null,
    };
}
