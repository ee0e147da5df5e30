using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Marks;

/// <summary>A mark at a point of the drawing.</summary>
/// <param name="Place">Drawing units.</param>
/// <param name="Direction">Direction of travel, for an arrow; zero for none.</param>
/// <param name="Number">Drawn beside the mark if its kind has a number.</param>
internal readonly record struct SceneMark(Point2D Place, MarkKind Kind, Vector2D Direction = default, int Number = 0);
