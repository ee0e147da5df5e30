using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Overlays;

/// <summary>Where the machine really was.</summary>
/// <param name="Place">Drawing units.</param>
/// <param name="ErrorFraction">Following error as a part of what is tolerated: 0 none, 1 and above all of it.</param>
/// <param name="ToolOn">False where the tool was up: the line to it is left out.</param>
public readonly record struct RecordedPlace(Point2D Place, double ErrorFraction, bool ToolOn);
