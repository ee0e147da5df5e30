using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Overlays;

/// <summary>A recorded position of the machine.</summary>
/// <param name="Place">Drawing units.</param>
/// <param name="ErrorFraction">The coloured value as a fraction of its tolerance or of the largest value: 0 none, 1 and above all of it.</param>
/// <param name="ToolOn">False if the tool was off: the line to the position is omitted.</param>
public readonly record struct RecordedPlace(Point2D Place, double ErrorFraction, bool ToolOn);
