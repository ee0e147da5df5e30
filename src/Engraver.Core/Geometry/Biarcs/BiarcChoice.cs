namespace Engraver.Core.Geometry.Biarcs;

/// <summary>Searches all biarcs between two points of a run, with given directions there, for one within the tolerance.</summary>
/// <remarks>A few samples show which members of the family are worth a proof; <see cref="ArcDeviation"/> does the proof.</remarks>
internal sealed class BiarcChoice(SmoothRun run, double tolerance)
{
    private const int JointSteps = 60;
    private const int Samples = 12;
    private const int Proofs = 2;

    /// <summary>Sine of the largest angle between an arc's end direction and the curve's that is ignored; rounding of drawn circles is smaller.</summary>
    public const double SameDirection = 1e-4;

    /// <summary>First tangent lengths to try, as multiples of that of the pair with equal ones. The equal pair comes first and is sufficient in most
    /// cases.</summary>
    private static readonly double[] Shares = [1.0, 0.8, 1.25, 0.62, 1.6, 0.9, 1.1, 0.7, 1.4, 0.53, 1.9, 0.45, 2.2, 0.37, 2.7, 0.3, 3.3, 0.18, 5.5];

    private readonly Point2D[] _samples = new Point2D[Samples];

    /// <summary>A pair within the tolerance, null when none was found.</summary>
    /// <param name="from">Start place on the run.</param>
    /// <param name="leaving">Direction there, length 1.</param>
    /// <param name="to">End place on the run.</param>
    /// <param name="arriving">Direction there, length 1.</param>
    public Biarc? Between(double from, Vector2D leaving, double to, Vector2D arriving)
    {
        var (start, end) = (run.PlaceAt(from), run.PlaceAt(to));
        for (var i = 0; i < Samples; i++) _samples[i] = run.PlaceAt(from + ((to - from) * (i + 1) / (Samples + 1)));
        var tried = double.NaN;
        for (var proof = 0; proof < Proofs; proof++)
        {
            var share = MostLikely(start, leaving, end, arriving, tried);
            if (double.IsNaN(share) || Biarc.Between(start, leaving, end, arriving, share) is not { } pair) return null;
            if (IsWithin(from, to, pair)) return pair;
            tried = share;
        }

        return null;
    }

    /// <summary>The arc (or line) that leaves in a given direction, ends on the curve between two places and arrives in the curve's direction there; null where
    /// there is none within the tolerance.</summary>
    public (double To, TangentArc Arc)? SingleBetween(double from, Vector2D leaving, double low, double high)
    {
        if (Single(from, leaving, high) is { } atOnce) return (high, atOnce);
        var (atLow, atHigh) = (Mismatch(from, leaving, low), Mismatch(from, leaving, high));
        if (!(atLow * atHigh < 0.0)) return null;
        for (var step = 0; step < JointSteps / 2 && high - low > 1e-9; step++)
        {
            var middle = (low + high) / 2.0;
            if (atLow * Mismatch(from, leaving, middle) < 0.0) high = middle;
            else low = middle;
        }

        return Single(from, leaving, high) is { } arc ? (high, arc) : null;
    }

    /// <summary>The arc (or line) that leaves in a given direction and ends at a place of the curve in the curve's direction; null when the directions differ
    /// by more than a sine of <paramref name="sameDirection"/>, or it is not within the tolerance.</summary>
    public TangentArc? Single(double from, Vector2D leaving, double to, double sameDirection = SameDirection) =>
        Math.Abs(Mismatch(from, leaving, to)) <= sameDirection && TangentArc.From(run.PlaceAt(from), leaving, run.PlaceAt(to)) is var arc && IsWithin(from, to, arc) ? arc : null;

    /// <summary>Sine of the signed angle from the end of the arc to the curve; NaN where the arc would sweep a half turn or the curve points
    /// backwards.</summary>
    private double Mismatch(double from, Vector2D leaving, double to)
    {
        var (start, end) = (run.PlaceAt(from), run.PlaceAt(to));
        if (!(leaving.Dot(end - start) > 0.0)) return double.NaN;
        var (arriving, tangent) = (TangentArc.From(start, leaving, end).EndTangent, run.TangentAt(to));
        return arriving.Dot(tangent) > 0.5 ? arriving.Cross(tangent) : double.NaN;
    }

    private double MostLikely(Point2D start, Vector2D leaving, Point2D end, Vector2D arriving, double tried)
    {
        var (least, best) = (tolerance, double.NaN);
        foreach (var share in Shares)
        {
            if (share == tried || Biarc.Between(start, leaving, end, arriving, share) is not { } pair) continue;
            var stray = MaxDeviation(pair, least);
            if (stray < least) (least, best) = (stray, share);
            if (least < tolerance / 2.0) break;
        }

        return best;
    }

    /// <summary>Largest distance of a sample from its arc; once it exceeds <paramref name="enough"/>, any value above that.</summary>
    private double MaxDeviation(in Biarc pair, double enough)
    {
        var (joint, tangent) = (pair.Second.Start, pair.Second.StartTangent);
        var most = 0.0;
        for (var i = 0; i < Samples && most <= enough; i++)
        {
            var place = _samples[i];
            most = Math.Max(most, ArcDeviation.FromCircle(place, (place - joint).Dot(tangent) < 0.0 ? pair.First : pair.Second));
        }

        return most;
    }

    private bool IsWithin(double from, double to, in Biarc pair) =>
        JointBetween(from, to, pair.First.End, pair.First.EndTangent) is { } joint && IsWithin(from, joint, pair.First) && IsWithin(joint, to, pair.Second);

    /// <summary>Where the curve crosses the normal through the joint (false position, Illinois variant); null when both ends are on the same side of
    /// it.</summary>
    private double? JointBetween(double from, double to, Point2D joint, Vector2D tangent)
    {
        var (low, high) = (from, to);
        var (atLow, atHigh) = ((run.PlaceAt(low) - joint).Dot(tangent), (run.PlaceAt(high) - joint).Dot(tangent));
        if (!(atLow < 0.0) || !(atHigh > 0.0)) return null;
        var near = tolerance * ArcDeviation.EndShare / 4.0;
        var side = 0;
        for (var step = 0; step < JointSteps; step++)
        {
            var middle = step % 8 == 7 ? (low + high) / 2.0 : low + ((high - low) * (atLow / (atLow - atHigh)));
            var at = (run.PlaceAt(middle) - joint).Dot(tangent);
            if (Math.Abs(at) <= near) return middle;
            if (at < 0.0) (low, atLow, atHigh, side) = (middle, at, side < 0 ? atHigh / 2.0 : atHigh, -1);
            else (high, atHigh, atLow, side) = (middle, at, side > 0 ? atLow / 2.0 : atLow, 1);
        }

        return null;
    }

    private bool IsWithin(double from, double to, in TangentArc arc)
    {
        foreach (var piece in run.Between(from, to))
        {
            if (!ArcDeviation.IsWithin(piece, arc, tolerance)) return false;
        }

        return true;
    }
}
