namespace Engraver.Core.Machines.Origins;

/// <summary>A work origin: the counts, from the controller's own zero, at which the drawing's point 0,0 is. An axis that was never set is null.</summary>
/// <param name="X">Counts of the axis of the drawing's X.</param>
/// <param name="Y">Counts of the axis of the drawing's Y.</param>
/// <param name="Z">Counts of the tool's axis, where the machine has one.</param>
public sealed record WorkOrigin(long? X, long? Y, int? Z = null)
{
    /// <summary>It was not set: the controller's position was 0 when the first job began, as after power-on.</summary>
    public bool IsAssumed { get; init; }

    /// <summary>Axes of the machine profile with which each axis was set; empty for an assumed origin, which is where the controller counts 0 under every
    /// profile.</summary>
    public StoredAxes Axes { get; init; }

    /// <summary>The position of both plane axes; null while one of them is not set. A height that is not set counts 0.</summary>
    public CountsPoint? Plane => X is { } x && Y is { } y ? new CountsPoint(x, y, Z ?? 0) : null;

    /// <summary>The machine position of each axis in millimetres: X, Y and, where the machine has one, Z. Null for an axis that is not set.</summary>
    public IReadOnlyList<double?> ToMillimetres(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        var plane = profile.Scale.ToMillimetres(X ?? 0, Y ?? 0);
        double?[] inPlan = [X is null ? null : plane.X, Y is null ? null : plane.Y];
        return profile.Axes.Z is null ? inPlan : [.. inPlan, Z is { } z ? profile.Scale.ToMillimetres(z) : null];
    }
}
