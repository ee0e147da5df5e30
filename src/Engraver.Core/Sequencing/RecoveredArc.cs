using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>An arc or circle that stands for straight pieces of a contour.</summary>
/// <param name="Arc">With a sweep of exactly +-360 degrees a whole circle.</param>
/// <param name="Start">Exactly where the first piece starts.</param>
/// <param name="End">Exactly where the last piece ends.</param>
/// <param name="Deviation">Nowhere is a piece farther from the arc than this, nor the arc from the pieces, mm.</param>
internal readonly record struct RecoveredArc(ArcSegment Arc, Point2D Start, Point2D End, double Deviation);
