namespace Engraver.Core.Kerf;

/// <summary>How a job is compensated for the radius of its tool.</summary>
/// <param name="Side">Not <see cref="KerfSide.Off"/>.</param>
/// <param name="ToolDiameterMm">Above 0.</param>
/// <param name="MaxErrorMm">Largest distance of the arcs that approximate an ellipse or spline, millimetres.</param>
/// <param name="JoinToleranceMm">Gaps that were closed between drawn ends, millimetres.</param>
/// <param name="CutsHeights">The machine cuts at the drawn heights.</param>
public sealed record KerfOptions(KerfSide Side, double ToolDiameterMm, double MaxErrorMm, double JoinToleranceMm, bool CutsHeights)
{
    public double Radius => ToolDiameterMm / 2.0;

    /// <summary>Maximum difference of the compensated path from the radius, millimetres.</summary>
    public double Tolerance => MaxErrorMm + JoinToleranceMm + 1e-6;
}
