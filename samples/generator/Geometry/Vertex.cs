namespace Engraver.Samples.Geometry;

/// <summary>A corner of a contour. <paramref name="Bulge"/> is tan(sweep/4) of the piece that leaves it: 0 is a line, positive is counter-clockwise.</summary>
internal readonly record struct Vertex(Point At, double Bulge = 0);
