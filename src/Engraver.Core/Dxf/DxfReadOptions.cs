using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf;

/// <summary>The operator's choices before a drawing is read.</summary>
/// <param name="UnitOverride">The unit to use instead of the file's (its <see cref="LengthUnit.Source"/> is "option"); null uses the file's.</param>
/// <param name="MaxExpandedCurves">Maximum number of curves and nested inserts that the expansion of blocks may visit in one drawing; an INSERT beyond that is
/// refused by name.</param>
/// <param name="Cut">Construction that is cut like curves.</param>
public sealed record DxfReadOptions(LengthUnit? UnitOverride = null, int MaxExpandedCurves = 10_000_000, CutChoice Cut = CutChoice.None)
{
    public static DxfReadOptions Default { get; } = new();

    /// <summary>Construction whose outlines are read as areas for operations; it is not cut otherwise.</summary>
    public CutChoice Areas { get; init; }

    /// <summary>Receives the part of the file that has been read, 0 to 1, about a hundred times, on the reading thread; null for none.</summary>
    public IProgress<double>? Progress { get; init; }
}
