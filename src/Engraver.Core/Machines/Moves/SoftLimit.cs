namespace Engraver.Core.Machines.Moves;

/// <summary>The ends of an axis' travel, counts from the controller's own zero; both may be reached.</summary>
/// <param name="Axis">The controller's letter.</param>
public readonly record struct SoftLimit(char Axis, int Min, int Max)
{
    /// <summary>No limit, as while an axis is homed and its position is unknown.</summary>
    public static SoftLimit None(char axis) => new(axis, int.MinValue, int.MaxValue);
}
