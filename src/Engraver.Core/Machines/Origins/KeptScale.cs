namespace Engraver.Core.Machines.Origins;

/// <summary>The counts per millimetre of the machine profile under which something was kept, by the drawing's axes; null where nobody knows them: in a file of an older version, and for an axis that was not set.</summary>
/// <remarks>What is kept are counts, which mean the same place under every profile. But a profile with other counts per millimetre describes another machine, or one of the two is wrong: the work would become too large or too small there.</remarks>
public readonly record struct KeptScale(double? X, double? Y, double? Z)
{
    public static KeptScale Of(CountsScale scale) => new(scale.X, scale.Y, scale.Z == 0.0 ? null : scale.Z);

    /// <summary>What is not known is taken from another.</summary>
    public KeptScale Or(KeptScale other) => new(X ?? other.X, Y ?? other.Y, Z ?? other.Z);

    /// <summary>As far as an origin is set.</summary>
    public KeptScale For(WorkOrigin origin)
    {
        ArgumentNullException.ThrowIfNull(origin);
        return new KeptScale(origin.X is null ? null : X, origin.Y is null ? null : Y, origin.Z is null ? null : Z);
    }

    /// <summary>The first axis that counts otherwise by a machine profile; null where none does. An axis that is not known, and one that the profile has not, differs from none.</summary>
    public ScaleDifference? DifferenceFrom(CountsScale scale)
    {
        var now = Of(scale);
        return Difference("X", X, now.X) ?? Difference("Y", Y, now.Y) ?? Difference("Z", Z, now.Z);
    }

    private static ScaleDifference? Difference(string axis, double? then, double? now) => then is { } was && now is { } counts && was != counts ? new ScaleDifference(axis, was, counts) : null;
}

/// <summary>An axis of the drawing that is counted by two measures.</summary>
/// <param name="Axis">X, Y or Z.</param>
/// <param name="Then">Counts per millimetre when something was kept.</param>
/// <param name="Now">Counts per millimetre of the machine profile in use.</param>
public readonly record struct ScaleDifference(string Axis, double Then, double Now);
