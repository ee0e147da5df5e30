namespace Engraver.Core.Kerf;

/// <summary>On which side of what is drawn the tool runs.</summary>
public enum KerfSide
{
    /// <summary>On the line.</summary>
    Off,

    /// <summary>Outermost contours on their outside, holes on their inside, and so on in turn: the part gets the size that is drawn.</summary>
    Nesting,

    /// <summary>Every closed contour on its outside, each by itself.</summary>
    Outside,

    /// <summary>Every closed contour on its inside, each by itself.</summary>
    Inside,

    /// <summary>To the left of the direction in which each contour was drawn.</summary>
    Left,

    /// <summary>To the right of it.</summary>
    Right,
}

/// <summary>How a job is compensated for the radius of its tool.</summary>
/// <param name="Side">Not <see cref="KerfSide.Off"/>.</param>
/// <param name="ToolDiameterMm">Above 0.</param>
/// <param name="MaxErrorMm">Largest distance of the arcs that stand for an ellipse or spline, millimetres.</param>
/// <param name="JoinToleranceMm">Gaps that were closed between drawn ends, millimetres.</param>
/// <param name="CutsHeights">The machine cuts at the heights that are drawn.</param>
public sealed record KerfOptions(KerfSide Side, double ToolDiameterMm, double MaxErrorMm, double JoinToleranceMm, bool CutsHeights)
{
    public double Radius => ToolDiameterMm / 2.0;

    /// <summary>How far the compensated path may be off the radius, millimetres.</summary>
    public double Tolerance => MaxErrorMm + JoinToleranceMm + 1e-6;
}

/// <summary>A place of the drawing that the tool leaves standing.</summary>
/// <param name="Place">Where most is left, millimetres.</param>
/// <param name="Uncut">Largest distance of the drawn line from what the tool reaches, millimetres.</param>
/// <param name="Entity">Drawing entity at the place.</param>
/// <param name="IsWhole">Nothing of the contour is reached.</param>
public sealed record UncutPlace(Geometry.Point2D Place, double Uncut, int Entity, bool IsWhole);
