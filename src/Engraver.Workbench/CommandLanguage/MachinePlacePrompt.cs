using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a machine position: <c>x,y</c> by the controller's own zero. A click on the canvas and <c>@</c> are no answers, because they are places of the drawing.</summary>
public sealed record MachinePlacePrompt(string Instruction) : ValuePrompt<MachinePlace>(Instruction)
{
    public override Reading<MachinePlace> Read(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var parts = typed.Split(',');
        return parts.Length == 2 && NumberPrompt.TryNumber(parts[0], out var x) && NumberPrompt.TryNumber(parts[1], out var y) && double.IsFinite(x) && double.IsFinite(y)
            ? new Reading<MachinePlace>.Value(new MachinePlace(x, y))
            : new Reading<MachinePlace>.Wrong(Wording.Get("MachinePlacePrompt.NoMachinePositionType", typed));
    }
}

/// <summary>A place by the controller's own zero, mm.</summary>
public sealed record MachinePlace(double X, double Y);
