using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a machine position: <c>x,y</c> relative to the controller's zero, and <c>x,y,z</c> if a height is allowed. Clicks on the canvas and
/// <c>@</c> are not accepted, because they are points of the drawing.</summary>
public sealed record MachinePositionPrompt(string Instruction) : ValuePrompt<TypedMachinePosition>(Instruction)
{
    /// <summary>A third number, the height, is allowed.</summary>
    public bool AllowsZ { get; init; }

    public override ParsedInput<TypedMachinePosition> Parse(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var parts = typed.Split(',');
        var z = 0.0;
        return (parts.Length == 2 || (AllowsZ && parts.Length == 3 && NumberPrompt.TryParse(parts[2], out z))) && NumberPrompt.TryParse(parts[0], out var x) && NumberPrompt.TryParse(parts[1], out var y)
            ? new ParsedInput<TypedMachinePosition>.Value(new TypedMachinePosition(x, y, parts.Length == 3 ? z : null))
            : new ParsedInput<TypedMachinePosition>.Invalid(Wording.Get(AllowsZ ? "MachinePositionPrompt.InvalidPositionWithHeight" : "MachinePositionPrompt.InvalidPosition", typed));
    }
}
