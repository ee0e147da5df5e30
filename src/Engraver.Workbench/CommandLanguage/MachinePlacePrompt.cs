using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a machine position: <c>x,y</c> relative to the controller's zero, and <c>x,y,z</c> if a height is allowed. Clicks on the canvas and
/// <c>@</c> are not accepted, because they are points of the drawing.</summary>
public sealed record MachinePlacePrompt(string Instruction) : ValuePrompt<MachinePlace>(Instruction)
{
    /// <summary>A third number, the height, is allowed.</summary>
    public bool MayHaveHeight { get; init; }

    public override Reading<MachinePlace> Read(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var parts = typed.Split(',');
        var z = 0.0;
        return (parts.Length == 2 || (MayHaveHeight && parts.Length == 3 && NumberPrompt.TryNumber(parts[2], out z))) && NumberPrompt.TryNumber(parts[0], out var x) && NumberPrompt.TryNumber(parts[1], out var y)
            ? new Reading<MachinePlace>.Value(new MachinePlace(x, y, parts.Length == 3 ? z : null))
            : new Reading<MachinePlace>.Wrong(Wording.Get(MayHaveHeight ? "MachinePlacePrompt.InvalidPositionWithHeight" : "MachinePlacePrompt.InvalidPosition", typed));
    }
}

/// <summary>A position relative to the controller's zero, mm.</summary>
/// <param name="Z">Null if no height was given.</param>
public sealed record MachinePlace(double X, double Y, double? Z = null)
{
    public Point2D Plane => new(X, Y);

    /// <summary>True if the position is in the counter range of the controller.</summary>
    public bool IsCountable(CountsScale scale) => scale.Holds(Bounds2D.FromCorners(Plane, Plane), default) && scale.HoldsHeight(Z ?? 0.0);

    /// <summary>Counts; the height is 0 if none was given.</summary>
    public CountsPoint ToCounts(CountsScale scale) => scale.ToCounts(Plane) with { Z = scale.ToHeight(Z ?? 0.0) };
}
