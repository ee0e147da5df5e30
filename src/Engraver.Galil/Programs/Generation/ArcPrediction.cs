using Engraver.Core.Geometry;

namespace Engraver.Galil.Programs.Generation;

/// <summary>The path of a CR from a given position: the centre is P - r(cos theta, sin theta), the end follows from the angles as the controller keeps them
/// (galil-dmc.md B.3).</summary>
/// <remarks>Inside a sequence the controller keeps the real end point after CR, so the next arc starts from <see cref="End"/>, not from whole counts.</remarks>
/// <param name="From">Position of the controller before it, counts.</param>
/// <param name="Radius">Whole counts.</param>
/// <param name="ThetaDegrees">As the controller keeps it.</param>
/// <param name="DeltaDegrees">As the controller keeps it; counter-clockwise positive.</param>
public readonly record struct ArcPrediction(Point2D From, int Radius, double ThetaDegrees, double DeltaDegrees)
{
    public Point2D Centre => From - Vector2D.FromPolar(Radius, Angle.FromDegrees(ThetaDegrees));

    /// <summary>Position of the controller after it. A whole turn returns to <see cref="From"/> itself.</summary>
    public Point2D End => Path.IsFullTurn ? From : Path.EndPoint;

    public double Length => Path.Length;

    private ArcSegment Path => new(Centre, Radius, Angle.FromDegrees(ThetaDegrees), Angle.FromDegrees(DeltaDegrees));

    /// <summary>Largest distance between the cut path and the circle of the wanted arc (counts, exact, not sampled).</summary>
    /// <remarks>From the wanted centre a point of the path is at |d + r u| with d the offset of the centre; that is monotone between the directions of d
    /// and -d,
    /// so that only these two and the two ends of the path can be the worst.</remarks>
    public double DeviationFrom(ArcSegment wanted)
    {
        var path = Path;
        var shift = path.Centre - wanted.Centre;
        var worst = Math.Max(Off(path.StartPoint, wanted), Off(path.EndPoint, wanted));
        if (path.Covers(shift.Direction)) worst = Math.Max(worst, Math.Abs(Radius + shift.Length - wanted.Radius));
        if (path.Covers((-shift).Direction)) worst = Math.Max(worst, Math.Abs(Math.Abs(Radius - shift.Length) - wanted.Radius));
        return worst;
    }

    private static double Off(Point2D place, ArcSegment wanted) => Math.Abs(place.DistanceTo(wanted.Centre) - wanted.Radius);
}
