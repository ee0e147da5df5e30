namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>A line in its column.</summary>
/// <param name="Baseline">From the top of the columns; 0 or negative.</param>
internal readonly record struct FlowedLine(SetLine Line, int Column, double Baseline);
