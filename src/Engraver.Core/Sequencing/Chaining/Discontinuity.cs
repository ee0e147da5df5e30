using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>A contour end with no partner within the join tolerance.</summary>
public readonly record struct Discontinuity
{
    private readonly double _gap;

    /// <param name="place">Position, millimetres.</param>
    /// <param name="row">The row that ends here.</param>
    /// <param name="gap">Distance to the nearest other open end; null when there is no other.</param>
    /// <param name="nearestRow">The row of that other end; -1 without one.</param>
    public Discontinuity(Point2D place, int row, double? gap, int nearestRow) => (Place, Row, _gap, NearestRow) = (place, row, gap ?? double.NaN, nearestRow);

    /// <summary>Position, millimetres.</summary>
    public Point2D Place { get; }

    /// <summary>The row that ends here.</summary>
    public int Row { get; }

    /// <summary>Distance to the nearest other open end (it can be the other end of the same contour, but not that of a single short segment); null without
    /// another.</summary>
    public double? Gap => double.IsNaN(_gap) ? null : _gap;

    /// <summary>The row of that other end; -1 without one.</summary>
    public int NearestRow { get; }
}
