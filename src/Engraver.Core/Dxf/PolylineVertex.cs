namespace Engraver.Core.Dxf;

/// <summary>A vertex of a polyline in the polyline's own system; the bulge belongs to the part that starts here.</summary>
internal record struct PolylineVertex(double X, double Y, double Z, double Bulge);
