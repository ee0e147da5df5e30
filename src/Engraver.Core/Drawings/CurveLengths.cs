namespace Engraver.Core.Drawings;

/// <summary>Lengths by kind, along the curves in space, drawing units. The straight parts of polylines count as lines, their bulge parts as arcs.</summary>
/// <param name="PlanTotal">Length of all curves, in plan.</param>
public sealed record CurveLengths(double Line, double Arc, double Circle, double Ellipse, double Spline, double PlanTotal)
{
    public double Total => Line + Arc + Circle + Ellipse + Spline;
}
