using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for the direction of a jog: a step <c>x,y</c> in mm, or the name and sign of an axis (<c>X+</c>).</summary>
/// <param name="HasHeight">The machine has a Z axis.</param>
internal sealed record JogStepPrompt(string Instruction, bool HasHeight) : ValuePrompt<JogStep>(Instruction)
{
    public override Reading<JogStep> Read(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var parts = typed.Split(',');
        if (parts.Length == 2 && NumberPrompt.TryNumber(parts[0], out var x) && NumberPrompt.TryNumber(parts[1], out var y)) return new Reading<JogStep>.Value(new JogStep(new Vector2D(x, y), 0.0, IsWhole: true));
        return Direction(typed) is { } way ? new Reading<JogStep>.Value(way) : new Reading<JogStep>.Wrong(Wording.Get("CncJog.NotAStep", typed));
    }

    private JogStep? Direction(string typed) => typed.ToUpperInvariant() switch
    {
        "X+" => new JogStep(new Vector2D(1, 0), 0.0, IsWhole: false),
        "X-" => new JogStep(new Vector2D(-1, 0), 0.0, IsWhole: false),
        "Y+" => new JogStep(new Vector2D(0, 1), 0.0, IsWhole: false),
        "Y-" => new JogStep(new Vector2D(0, -1), 0.0, IsWhole: false),
        "Z+" when HasHeight => new JogStep(default, 1.0, IsWhole: false),
        "Z-" when HasHeight => new JogStep(default, -1.0, IsWhole: false),
        _ => null,
    };
}

/// <summary>Direction of a jog.</summary>
/// <param name="Way">Millimetres of the drawing's axes; a direction has length 1.</param>
/// <param name="Height">The same for Z.</param>
/// <param name="IsWhole">The distance is included; otherwise only the direction is given.</param>
internal sealed record JogStep(Vector2D Way, double Height, bool IsWhole);
