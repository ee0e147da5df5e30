using Engraver.Core.Geometry;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Chooses the CR that follows a desired arc from the controller's actual position, or none if a single CR would deviate from the arc.</summary>
/// <remarks>All lengths are counts. The radius is the desired one, rounded; theta and delta are chosen.</remarks>
/// <param name="Quantum">The controller's resolution of angles.</param>
internal readonly record struct ArcCommandFit(AngleQuantum Quantum)
{
    /// <summary>Largest distance of a path from the desired arc, counts; the remainder to one count allows for the controller's arithmetic.</summary>
    private const double MaxDeviation = 0.98;

    /// <summary>The first candidate within this distance is used, so that arcs on whole counts keep the numbers of the drawing.</summary>
    private const double GoodEnough = 0.75;

    /// <summary>The controller might round an end this close to the middle between two counts either way.</summary>
    private const double RoundingMargin = 0.02;

    /// <summary>An inner piece may end before or after its target by this fraction of its length, because the next piece starts from there.</summary>
    private const double MaxInnerEndShare = 0.25;

    private const double ShortestArc = 2.0;

    /// <summary>The CR that cuts the whole desired arc and ends within a count of <paramref name="trueEnd"/>, at a point whose rounding is certain.</summary>
    public ArcPrediction? ToEnd(Point2D from, ArcSegment wanted, Point2D target, Point2D trueEnd)
    {
        return Best(from, wanted, target, arc => IsSurelyRounded(arc.End) ? Math.Max(arc.DeviationFrom(wanted), arc.End.DistanceTo(trueEnd)) : double.PositiveInfinity);
    }

    /// <summary>The CR for a piece that is followed by another piece of the same arc.</summary>
    public ArcPrediction? ToMark(Point2D from, ArcSegment wanted)
    {
        var mark = wanted.EndPoint;
        return Best(from, wanted, mark, arc => arc.End.DistanceTo(mark) <= MaxInnerEndShare * wanted.Length ? arc.DeviationFrom(wanted) : double.PositiveInfinity);
    }

    /// <summary>True when the controller accepts a CR of this radius.</summary>
    public static bool CanHold(double radius) => Math.Round(radius) is >= DmcLimits.SmallestRadius and <= DmcLimits.LargestRadius;

    private ArcPrediction? Best(Point2D from, ArcSegment wanted, Point2D target, Func<ArcPrediction, double> off)
    {
        var best = default(ArcPrediction?);
        var bestOff = MaxDeviation;
        foreach (var aim in Candidates(from, wanted, target))
        {
            if (!IsLegal(aim)) continue;
            var aimOff = off(aim);
            if (aimOff <= GoodEnough) return aim;
            if (aimOff > bestOff) continue;
            (best, bestOff) = (aim, aimOff);
        }

        return best;
    }

    /// <summary>Candidates in order: as drawn; around the drawn centre; through both ends.</summary>
    private IEnumerable<ArcPrediction> Candidates(Point2D from, ArcSegment wanted, Point2D target)
    {
        var radius = (int)Math.Round(wanted.Radius, MidpointRounding.AwayFromZero);
        yield return new ArcPrediction(from, radius, Quantum.QuantizeDirection(wanted.Start.Degrees), Quantum.Quantize(wanted.Sweep.Degrees));
        yield return Aimed(from, radius, (from - wanted.Centre).Direction, wanted, target);
        if (CentreThrough(from, target, radius, wanted) is { } centre) yield return Aimed(from, radius, (from - centre).Direction, wanted, target);
    }

    private ArcPrediction Aimed(Point2D from, int radius, Angle theta, ArcSegment wanted, Point2D target)
    {
        var kept = Quantum.QuantizeDirection(theta.Degrees);
        var sweep = wanted.Sweep.Degrees;
        if (wanted.IsFullTurn) return new ArcPrediction(from, radius, kept, sweep);
        var centre = new ArcPrediction(from, radius, kept, 0.0).Centre;
        var turn = (target - centre).Direction.Degrees - kept;
        return new ArcPrediction(from, radius, kept, Quantum.Quantize(sweep + Math.IEEERemainder(turn - sweep, 360.0)));
    }

    /// <summary>The centre at distance <paramref name="radius"/> from both points, on the side of the desired arc's centre; null when they are too far apart or
    /// coincide.</summary>
    private static Point2D? CentreThrough(Point2D from, Point2D to, int radius, ArcSegment wanted)
    {
        var chord = to - from;
        var length = chord.Length;
        if (length < 1.0 || length > 2.0 * radius) return null;
        var height = Math.Sqrt(((double)radius * radius) - (length * length / 4.0));
        var left = wanted.Sweep.Degrees > 0.0 == Math.Abs(wanted.Sweep.Degrees) < 180.0;
        var normal = new Vector2D(-chord.Y, chord.X) * ((left ? height : -height) / length);
        return from + (chord * 0.5) + normal;
    }

    private static bool IsLegal(ArcPrediction aim) => aim.Length >= ShortestArc && aim.Radius * Math.Abs(aim.DeltaDegrees) < DmcLimits.RadiusTimesDegrees;

    private static bool IsSurelyRounded(Point2D place) => IsSurelyRounded(place.X) && IsSurelyRounded(place.Y);

    private static bool IsSurelyRounded(double value) => Math.Abs(value - Math.Floor(value) - 0.5) >= RoundingMargin;
}
