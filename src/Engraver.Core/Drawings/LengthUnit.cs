namespace Engraver.Core.Drawings;

/// <summary>The length unit of a drawing.</summary>
/// <param name="Code">$INSUNITS, 1 to 24; 0 when none is given.</param>
/// <param name="Name">Short name ("mm", "in").</param>
/// <param name="Source">Where the unit comes from: "INSUNITS", "assumed" or "option".</param>
/// <param name="ToMillimetres">Factor from drawing units to millimetres.</param>
public sealed record LengthUnit(int Code, string Name, string Source, double ToMillimetres)
{
    public static LengthUnit AssumedMillimetres { get; } = new(0, "mm", "assumed", 1.0);
}
