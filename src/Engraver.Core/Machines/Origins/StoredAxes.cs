namespace Engraver.Core.Machines.Origins;

/// <summary>The controller's axes and their counts per millimetre by the machine profile under which a value was stored, by the drawing's axes; null where they
/// are unknown: in a file of an older version, and for an axis that was not set.</summary>
/// <remarks>The stored values are counts, which mean the same point under every profile with the same axes. A profile with other axes or other counts per
/// millimetre describes another machine, or one of the two is wrong: the work would be at another point, or be too large or too small there.</remarks>
public readonly record struct StoredAxes(StoredAxis? X, StoredAxis? Y, StoredAxis? Z)
{
    public static StoredAxes Of(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return new StoredAxes(Of(profile.Axes.X), Of(profile.Axes.Y), profile.Axes.Z is { } z ? Of(z) : null);
    }

    /// <summary>The counts per millimetre without the letters, which a homing records elsewhere (<see cref="MachineProfile.HomedAs"/>).</summary>
    public StoredAxes WithoutLetters() => new(X is { } x ? x with { Letter = null } : null, Y is { } y ? y with { Letter = null } : null, Z is { } z ? z with { Letter = null } : null);

    /// <summary>Takes what is not known from another value.</summary>
    public StoredAxes Or(StoredAxes other) => new(Or(X, other.X), Or(Y, other.Y), Or(Z, other.Z));

    /// <summary>Only the axes in which an origin is set.</summary>
    public StoredAxes For(WorkOrigin origin)
    {
        ArgumentNullException.ThrowIfNull(origin);
        return new StoredAxes(origin.X is null ? null : X, origin.Y is null ? null : Y, origin.Z is null ? null : Z);
    }

    /// <summary>The first axis that is another one, or has other counts per millimetre, under a machine profile; null where there is none. Unknown values, and
    /// axes that the profile does not have, are not differences.</summary>
    public AxisDifference? DifferenceFrom(MachineProfile profile)
    {
        var now = Of(profile);
        return Difference(0, X, now.X) ?? Difference(1, Y, now.Y) ?? Difference(2, Z, now.Z);
    }

    private static StoredAxis Of(MachineAxis axis) => new(axis.CountsPerMillimetre, axis.Letter);

    private static StoredAxis? Or(StoredAxis? known, StoredAxis? other) => known is { } axis ? axis with { Letter = axis.Letter ?? other?.Letter } : other;

    private static AxisDifference? Difference(int axis, StoredAxis? then, StoredAxis? now) =>
        then is { } was && now is { } present && (was.Counts != present.Counts || (was.Letter is { } letter && letter != present.Letter)) ? new AxisDifference(MachineAxes.Names[axis].ToString(), was, present) : null;
}

/// <summary>An axis of the drawing that two machine profiles describe differently.</summary>
/// <param name="Axis">X, Y or Z.</param>
/// <param name="Stored">When the value was stored.</param>
/// <param name="Current">According to the machine profile in use.</param>
public readonly record struct AxisDifference(string Axis, StoredAxis Stored, StoredAxis Current)
{
    /// <summary>True when the drawing's axis is now another one of the controller.</summary>
    public bool IsOtherLetter => Stored.Letter is { } then && then != Current.Letter;
}
