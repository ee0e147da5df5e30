using Engraver.Core.Geometry;

namespace Engraver.Galil.Programs.Generation;

/// <summary>The path of a CR from a given position: the centre is P - r(cos theta, sin theta), the end follows from the angles as the controller stores them
/// (galil-dmc.md B.3).</summary>
/// <remarks>Inside a sequence the controller keeps the exact end point after CR, so the next arc starts from <see cref="End"/>, not from whole
/// counts.</remarks>
/// <param name="From">Position of the controller before it, counts.</param>
/// <param name="Radius">Whole counts.</param>
/// <param name="ThetaDegrees">As the controller stores it.</param>
/// <param name="DeltaDegrees">As the controller stores it; counter-clockwise positive.</param>
public readonly record struct ArcPrediction(Point2D From, int Radius, double ThetaDegrees, double DeltaDegrees)
{
    public Point2D Centre => From - Vector2D.FromPolar(Radius, Angle.FromDegrees(ThetaDegrees));

    /// <summary>Position of the controller after it. A full turn returns to <see cref="From"/> exactly.</summary>
    public Point2D End => Path.IsFullTurn ? From : Path.EndPoint;

    public double Length => Path.Length;

    private ArcSegment Path => new(Centre, Radius, Angle.FromDegrees(ThetaDegrees), Angle.FromDegrees(DeltaDegrees));

    /// <summary>Largest distance between the cut path and the circle of the desired arc (counts, exact, not sampled).</summary>
    /// <remarks>The distance of a point of the path from the desired centre is |d + r u|, where d is the offset of the centres. It is monotone between the
    /// directions of d and -d, so that the maximum is at one of these two or at an end of the path.</remarks>
    public double DeviationFrom(ArcSegment wanted)
    {
        var path = Path;
        var shift = path.Centre - wanted.Centre;
        var worst = Math.Max(DistanceFromCircle(path.StartPoint, wanted), DistanceFromCircle(path.EndPoint, wanted));
        if (path.Covers(shift.Direction)) worst = Math.Max(worst, Math.Abs(Radius + shift.Length - wanted.Radius));
        if (path.Covers((-shift).Direction)) worst = Math.Max(worst, Math.Abs(Math.Abs(Radius - shift.Length) - wanted.Radius));
        return worst;
    }

    private static double DistanceFromCircle(Point2D place, ArcSegment wanted) => Math.Abs(place.DistanceTo(wanted.Centre) - wanted.Radius);
}
