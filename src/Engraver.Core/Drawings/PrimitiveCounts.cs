namespace Engraver.Core.Drawings;

/// <summary>What the curves consist of: polylines taken apart into lines and arcs, and counted themselves.</summary>
/// <param name="Point">POINT entities; they are no curves.</param>
public sealed record PrimitiveCounts(int Line, int Arc, int Circle, int Ellipse, int Spline, int Polyline, int Point);
