using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf;

/// <summary>What the operator decides before a drawing is read.</summary>
/// <param name="UnitOverride">The unit to use whatever the file says (its <see cref="LengthUnit.Source"/> is "option"); null takes the file's word.</param>
/// <param name="MaxExpandedCurves">How many curves and nested inserts the expansion of blocks may visit in one drawing; an INSERT beyond that is refused by name.</param>
/// <param name="Cut">Construction that counts as curves.</param>
public sealed record DxfReadOptions(LengthUnit? UnitOverride = null, int MaxExpandedCurves = 10_000_000, CutChoice Cut = CutChoice.None)
{
    public static DxfReadOptions Default { get; } = new();

    /// <summary>Is told how much of the file has been read, 0 to 1, about a hundred times; on the reading thread. Null: nobody.</summary>
    public IProgress<double>? Progress { get; init; }
}
