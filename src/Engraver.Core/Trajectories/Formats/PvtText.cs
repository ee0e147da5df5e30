using System.Text;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>Positions, velocities and times of an XPS controller's MultipleAxes group with the positioners X and Y: <c>dt, dx, vx, dy, vy</c>, from rest to
/// rest (sace-xps-agie.md 2.4).</summary>
/// <remarks>The speed rises and falls inside the contour, so that only the contour is run. Each element is the cubic fixed by its two places and velocities;
/// with exact tangents its error is h^4 k^3 / 384 at a constant speed; where the speed changes from v to w, k (h d)^2 / 32 with d = (w - v) / (w + v) is added,
/// because along the curve the cubic is quadratic in time.</remarks>
internal static class PvtText
{
    /// <summary>Shortest element, seconds: known to be accepted.</summary>
    private const double ShortestSeconds = 0.0005;

    /// <summary>Fraction of the acceleration that is used; the rest is for the rounding of the text.</summary>
    private const double AccelerationShare = 0.9;

    private const int MaxRounds = 14;

    /// <summary>Ratio of the curvature at an end of a part to that inside: above it the part is halved.</summary>
    private const double MaxUnevenness = 16.0;

    /// <summary>Curvature times length, radians, below which a part counts as straight.</summary>
    private const double Straight = 1e-9;

    /// <summary>A part shorter than this fraction of the error is not divided further: a path through it cannot deviate by more.</summary>
    private const double ShortPart = 0.5;

    /// <summary>Fraction of the error reserved for a changing speed.</summary>
    private const double RampShare = 0.5;

    /// <summary>Shortest element at the end of a ramp, as a fraction of the chain.</summary>
    private const double MinPart = 1e-6;

    /// <returns>Null when no division is within the error.</returns>
    public static TrajectoryFile? From(SmoothChain chain, IReadOnlyList<Segment> source, TrajectoryOptions options, TrajectoryMotion motion)
    {
        var plan = new PvtSpeeds(chain, motion.Velocity, AccelerationShare * motion.Acceleration);
        for (var (round, scale) = (0, 1.0); round < MaxRounds; round++, scale *= 0.75)
        {
            var rows = Rows(chain, plan, Knots(chain, plan, options.MaxError, scale), motion.Acceleration);
            var knots = rows.Select(row => row.At).ToList();
            var bound = SplineBound.Measure(rows.Count - 1, i => CubicOf(rows[i], rows[i + 1]), chain, knots, options.MaxError);
            if (bound <= options.MaxError) return FileOf(chain, source, options, motion, rows, knots, bound);
        }

        return null;
    }

    /// <summary>Knots as lengths by quadrature: always the ends and joints, between them steps of the size that the error allows.</summary>
    private static List<double> Knots(SmoothChain chain, PvtSpeeds plan, double error, double scale)
    {
        var knots = new List<double> { 0.0 };
        foreach (var piece in chain.Pieces)
        {
            foreach (var (end, count) in Divided(piece, 0.0, 1.0, error, scale))
            {
                var start = knots[^1];
                for (var i = 1; i <= count; i++) knots.Add(i == count ? end : start + ((end - start) * i / count));
            }
        }

        foreach (var ramp in plan.Ramps)
        {
            var next = ~knots.BinarySearch(ramp);
            if (next > 0 && Math.Min(ramp - knots[next - 1], knots[next] - ramp) > MinPart * chain.Length) knots.Insert(next, ramp);
        }

        return Graded(chain, plan, knots, RampShare * error * scale * scale * scale * scale);
    }

    /// <summary>Parts of a piece, and the number of elements that the error requires for each. Where the curvature at an end differs much from that inside, as
    /// at the end of a spline whose first two control points are one (there it has no bound), the part is halved until one element is sufficient.</summary>
    /// <returns>The end of each part, as a length of the chain, in order, and the number of its elements.</returns>
    private static IEnumerable<(double End, int Count)> Divided(ChainPiece piece, double from, double to, double error, double scale)
    {
        var curvatures = Enumerable.Range(0, 9).Select(i => Math.Abs(piece.At(from + ((to - from) * i / 8.0)).Curvature)).ToArray();
        var (inside, ends) = (curvatures[1..8].Max(), Math.Max(curvatures[0], curvatures[8]));
        var (until, length) = (piece.ArcLengthAt(to), piece.ArcLengthAt(to) - piece.ArcLengthAt(from));
        if (length < ShortPart * error) return [(until, 1)];
        var uneven = !(ends <= MaxUnevenness * inside) && !(ends * length < Straight);
        if (!uneven) return [(until, Elements(length, Math.Max(inside, ends), error, scale))];
        return Elements(length, inside, error, scale) == 1 ? [(until, 1)] : [.. Divided(piece, from, (from + to) / 2.0, error, scale), .. Divided(piece, (from + to) / 2.0, to, error, scale)];
    }

    private static int Elements(double length, double curvature, double error, double scale)
    {
        var step = curvature * length < Straight ? length : Math.Min(1.0 / curvature, scale * Math.Pow(384.0 * error / (curvature * curvature * curvature), 0.25));
        return Math.Max(1, (int)Math.Ceiling(length / step));
    }

    /// <summary>Elements in which the speed changes on a bend are divided into equal changes of speed: the additional error of the change falls with the fourth
    /// power of their number.</summary>
    /// <param name="allowed">Largest allowed additional error, millimetres.</param>
    private static List<double> Graded(SmoothChain chain, PvtSpeeds plan, List<double> knots, double allowed)
    {
        var graded = new List<double> { knots[0] };
        for (var i = 1; i < knots.Count; i++)
        {
            var (from, step) = (knots[i - 1], knots[i] - knots[i - 1]);
            var (leave, arrive) = (SpeedAt(plan, knots, i - 1), SpeedAt(plan, knots, i));
            var (curvature, uneven) = (Enumerable.Range(1, 7).Max(k => Math.Abs(chain.AtArcLength(from + (step * k / 8.0)).Place.Curvature)), step * (arrive - leave) / (arrive + leave));
            var count = (int)Math.Ceiling(Math.Pow(curvature * uneven * uneven / (32.0 * allowed), 0.25));
            for (var k = 1; k < count; k++)
            {
                var speed = leave + ((arrive - leave) * k / count);
                graded.Add(from + (step * ((speed * speed) - (leave * leave)) / ((arrive * arrive) - (leave * leave))));
            }

            graded.Add(knots[i]);
        }

        return graded;
    }

    /// <summary>Zero at both ends.</summary>
    private static double SpeedAt(PvtSpeeds plan, List<double> knots, int index) => index == 0 || index == knots.Count - 1 ? 0.0 : plan.At(knots[index]);

    private static List<Station> Rows(SmoothChain chain, PvtSpeeds plan, List<double> knots, double acceleration)
    {
        List<(ChainPoint Place, double At)> places = [(chain.Pieces[0].At(0.0), 0.0), .. knots.Skip(1).SkipLast(1).Select(chain.AtArcLength), (chain.Pieces[^1].At(1.0), chain.Length)];
        var speeds = plan.AtKnots(knots, (i, leave, arrive) => Excess(Row(i - 1, leave, leave), Row(i, leave, arrive), acceleration));
        return [.. knots.Select((_, i) => Row(i, i == 0 ? 0.0 : speeds[i - 1], speeds[i]))];

        Station Row(int i, double before, double speed)
        {
            var (place, seconds) = (places[i].Place, i == 0 ? 0.0 : 2.0 * (knots[i] - knots[i - 1]) / (speed + before));
            return new Station(Round(seconds), new Point2D(Round(place.Point.X), Round(place.Point.Y)), new Vector2D(Round(place.Tangent.X * speed), Round(place.Tangent.Y * speed)), places[i].At);
        }
    }

    /// <summary>Requirement of an element divided by its limits: of the acceleration, and of the square of the shortest time.</summary>
    private static double Excess(in Station from, in Station to, double acceleration) =>
        Math.Max(MaxAcceleration(from, to) / acceleration, ShortestSeconds * ShortestSeconds / (to.Seconds * to.Seconds));

    private static double Round(double value) => Math.Round(value, SplineFit.Decimals);

    private static Cubic CubicOf(in Station from, in Station to)
    {
        var third = to.Seconds / 3.0;
        return new Cubic(from.Place, from.Place + (from.Velocity * third), to.Place - (to.Velocity * third), to.Place);
    }

    private static TrajectoryFile FileOf(SmoothChain chain, IReadOnlyList<Segment> source, TrajectoryOptions options, TrajectoryMotion motion, List<Station> rows, List<double> knots, double bound)
    {
        var (text, broken) = (new StringBuilder(), new List<string>());
        for (var i = 1; i < rows.Count; i++)
        {
            var (row, by) = (rows[i], rows[i].Place - rows[i - 1].Place);
            text.AppendJoin(", ", new[] { row.Seconds, by.X, row.Velocity.X, by.Y, row.Velocity.Y }.Select(TrajectoryFile.LongNumber)).Append('\n');
            AddLimits(broken, i, rows[i - 1], row, motion);
        }

        return new TrajectoryFile(text.ToString(), rows[0].Place, options.Z, rows.Count, SampledDistance.Of(rows.Count - 1, i => CubicOf(rows[i], rows[i + 1]), chain, knots), bound, 1.0, chain.Length, chain.Closed, source) { BrokenLimits = [.. broken, .. MotionLimits.BrokenTravel(source, motion)] };
    }

    /// <summary>Acceleration of an axis: that of a cubic is linear in time and therefore greatest at an end.</summary>
    private static double MaxAcceleration(in Station from, in Station to)
    {
        var (way, t) = (to.Place - from.Place, to.Seconds);
        var first = (way * (6.0 / (t * t))) - (from.Velocity * (4.0 / t)) - (to.Velocity * (2.0 / t));
        var last = (way * (-6.0 / (t * t))) + (from.Velocity * (2.0 / t)) + (to.Velocity * (4.0 / t));
        return Math.Max(Math.Max(Math.Abs(first.X), Math.Abs(last.X)), Math.Max(Math.Abs(first.Y), Math.Abs(last.Y)));
    }

    /// <summary>The speed of an element is checked at its ends.</summary>
    private static void AddLimits(List<string> broken, int element, in Station from, in Station to, TrajectoryMotion motion)
    {
        var (most, t) = (MaxAcceleration(from, to), to.Seconds);
        if (most > motion.Acceleration) broken.Add(Wording.Get("Xps.Acceleration", element, NumberText.Rounded(most, 4), NumberText.Rounded(motion.Acceleration, 4)));
        if (to.Velocity.Length > motion.Velocity * 1.000001) broken.Add(Wording.Get("Xps.Velocity", element, NumberText.Rounded(to.Velocity.Length, 4), NumberText.Rounded(motion.Velocity, 4)));
        if (t < ShortestSeconds && to.Place != from.Place) broken.Add(Wording.Get("Xps.ElementTooShort", element, NumberText.Rounded(t, 4)));
    }

    /// <param name="At">Position as a length of the chain.</param>
    private readonly record struct Station(double Seconds, Point2D Place, Vector2D Velocity, double At);
}
