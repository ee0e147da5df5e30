using Engraver.Core.Geometry;

namespace Engraver.Core.Toolpaths;

/// <summary>One cutting move in millimetres with the drawing entity it came from.</summary>
public readonly record struct ToolpathMove(Segment Segment, int EntityIndex);
