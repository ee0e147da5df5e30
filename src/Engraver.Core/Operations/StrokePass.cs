namespace Engraver.Core.Operations;

/// <summary>A pass of a stroke.</summary>
/// <param name="Operation">Its operation.</param>
/// <param name="Stroke">Index of the stroke in its operation.</param>
/// <param name="Pass">Index of the pass, 0 is the first.</param>
/// <param name="Depth">Depth below the top of the work, mm.</param>
public sealed record StrokePass(Operation Operation, int Stroke, int Pass, double Depth);
