using Engraver.Core.Geometry;

namespace Engraver.Workbench.Views;

/// <summary>A place that the canvas points at until the view changes by hand or another place is named.</summary>
/// <param name="Place">Drawing units.</param>
/// <param name="Text">What is there; may be empty.</param>
public sealed record ViewFocus(Point2D Place, string Text);
