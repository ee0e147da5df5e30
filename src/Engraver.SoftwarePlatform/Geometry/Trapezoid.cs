namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>Left and right ends of the upper and the lower side.</summary>
internal readonly record struct Trapezoid(double TopLeft, double TopRight, double BottomLeft, double BottomRight);
