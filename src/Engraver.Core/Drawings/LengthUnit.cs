namespace Engraver.Core.Drawings;

/// <summary>The length unit of a drawing.</summary>
/// <param name="Code">$INSUNITS, 1 to 24; 0 when the file has none.</param>
/// <param name="Name">Short name ("mm", "in").</param>
/// <param name="Source">The source of the unit: "INSUNITS", "LUNITS", "assumed" or "option".</param>
/// <param name="MillimetresPerUnit">Length of the unit; <see cref="DrawingScale"/> converts with it.</param>
public sealed record LengthUnit(int Code, string Name, string Source, double MillimetresPerUnit)
{
    /// <summary><see cref="Source"/> of a unit that the operator chose instead of the file's.</summary>
    public const string Chosen = "option";

    public static LengthUnit AssumedMillimetres { get; } = new(0, "mm", "assumed", 1.0);

    /// <summary>The unit of a drawing that does not state one and shows its lengths in feet and inches ($LUNITS 3 or 4).</summary>
    public static LengthUnit AssumedInches { get; } = new(0, "in", "LUNITS", LengthUnits.Inch);
}
