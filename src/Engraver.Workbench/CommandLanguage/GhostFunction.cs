using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>The preview of a command for a cursor position, drawing units; may be empty. Called while the cursor moves, on any thread, and must not change
/// state.</summary>
public delegate IReadOnlyList<Segment> GhostFunction(Point2D place);
