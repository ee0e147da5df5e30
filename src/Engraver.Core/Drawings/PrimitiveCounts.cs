namespace Engraver.Core.Drawings;

/// <summary>Numbers of curves: the lines and arcs of polylines are counted, and the polylines themselves.</summary>
/// <param name="Point">POINT entities, which are not curves.</param>
public sealed record PrimitiveCounts(int Line, int Arc, int Circle, int Ellipse, int Spline, int Polyline, int Point);
