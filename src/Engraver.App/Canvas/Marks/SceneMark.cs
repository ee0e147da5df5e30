using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Marks;

/// <summary>A sign at a place of the drawing.</summary>
/// <param name="Place">Drawing units.</param>
/// <param name="Direction">Of travel, for an arrow; zero for none.</param>
/// <param name="Number">Written beside it where the kind has a number.</param>
internal readonly record struct SceneMark(Point2D Place, MarkKind Kind, Vector2D Direction = default, int Number = 0);
