using System.Globalization;
using System.Text;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>Positions, velocities and times of an XPS controller's MultipleAxes group with the positioners X and Y: <c>dt, dx, vx, dy, vy</c>, from rest to rest (sace-xps-agie.md 2.4).</summary>
/// <remarks>The speed rises and falls inside the contour, so that nothing beside it is run. Each element is the cubic fixed by its two places and velocities; with exact tangents its error is h^4 k^3 / 384 at an even speed; where the speed changes from v to w, k (h d)^2 / 32 with d = (w - v) / (w + v) is added, because along the curve the cubic is quadratic in time.</remarks>
internal static class PvtText
{
    /// <summary>Shortest element, seconds: what is known to be taken.</summary>
    private const double ShortestSeconds = 0.0005;

    /// <summary>Part of the acceleration that is used; the rest is for the rounding of the text.</summary>
    private const double AccelerationShare = 0.9;

    private const int MostRounds = 14;

    /// <summary>Curvature at an end of a part over that inside: above it the part is halved.</summary>
    private const double MostUneven = 16.0;

    /// <summary>Curvature by length, radians, of what is taken for straight.</summary>
    private const double Straight = 1e-9;

    /// <summary>Part of the error that an uneven speed may take.</summary>
    private const double RampShare = 0.5;

    /// <summary>Shortest element as a part of the chain that is made for the end of a ramp.</summary>
    private const double LeastPart = 1e-6;

    /// <returns>Null when no division keeps the error.</returns>
    public static TrajectoryFile? From(SmoothChain chain, IReadOnlyList<Segment> source, TrajectoryOptions options, TrajectoryMotion motion)
    {
        var plan = new PvtSpeeds(chain, motion.Velocity, AccelerationShare * motion.Acceleration);
        for (var (round, scale) = (0, 1.0); round < MostRounds; round++, scale *= 0.75)
        {
            var knots = Knots(chain, plan, options.MaxError, scale);
            var rows = Rows(chain, plan, knots);
            var bound = SplineBound.Measure(rows.Count - 1, i => CubicOf(rows[i], rows[i + 1]), chain, knots, options.MaxError);
            if (bound <= options.MaxError) return FileOf(chain, source, options, motion, rows, knots, bound);
        }

        return null;
    }

    /// <summary>Ends and joints always, between them steps of the size that the error allows.</summary>
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
            if (next > 0 && Math.Min(ramp - knots[next - 1], knots[next] - ramp) > LeastPart * chain.Length) knots.Insert(next, ramp);
        }

        return Graded(chain, plan, knots, RampShare * error * scale * scale * scale * scale);
    }

    /// <summary>Parts of a piece, and into how many elements the error divides each. Where the curvature at an end is far from that inside, as at the end of a spline whose first two control points are one (there it has no bound), the part is halved until one element is enough.</summary>
    /// <returns>Where each part ends, as a length of the chain, in order, and the number of its elements.</returns>
    private static IEnumerable<(double End, int Count)> Divided(ChainPiece piece, double from, double to, double error, double scale)
    {
        var curvatures = Enumerable.Range(0, 9).Select(i => Math.Abs(piece.At(from + ((to - from) * i / 8.0)).Curvature)).ToArray();
        var (inside, ends) = (curvatures[1..8].Max(), Math.Max(curvatures[0], curvatures[8]));
        var (until, length) = (piece.LengthAt(to), piece.LengthAt(to) - piece.LengthAt(from));
        var uneven = !(ends <= MostUneven * inside) && !(ends * length < Straight);
        if (!uneven) return [(until, Elements(length, Math.Max(inside, ends), error, scale))];
        return Elements(length, inside, error, scale) == 1 ? [(until, 1)] : [.. Divided(piece, from, (from + to) / 2.0, error, scale), .. Divided(piece, (from + to) / 2.0, to, error, scale)];
    }

    private static int Elements(double length, double curvature, double error, double scale)
    {
        var step = curvature * length < Straight ? length : Math.Min(1.0 / curvature, scale * Math.Pow(384.0 * error / (curvature * curvature * curvature), 0.25));
        return Math.Max(1, (int)Math.Ceiling(length / step));
    }

    /// <summary>Elements in which the speed changes on a bend are divided into equal changes of speed: the error of what the change adds falls with the fourth power of their number.</summary>
    /// <param name="allowed">Of that error, millimetres.</param>
    private static List<double> Graded(SmoothChain chain, PvtSpeeds plan, List<double> knots, double allowed)
    {
        var graded = new List<double> { knots[0] };
        for (var i = 1; i < knots.Count; i++)
        {
            var (from, step) = (knots[i - 1], knots[i] - knots[i - 1]);
            var (leave, arrive) = (SpeedAt(plan, knots, i - 1), SpeedAt(plan, knots, i));
            var (curvature, uneven) = (Enumerable.Range(1, 7).Max(k => Math.Abs(chain.At(from + (step * k / 8.0)).Curvature)), step * (arrive - leave) / (arrive + leave));
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

    private static List<Station> Rows(SmoothChain chain, PvtSpeeds plan, List<double> knots)
    {
        var rows = new List<Station>();
        for (var i = 0; i < knots.Count; i++)
        {
            var place = i == 0 ? chain.Pieces[0].At(0.0) : i == knots.Count - 1 ? chain.Pieces[^1].At(1.0) : chain.At(knots[i]);
            var speed = SpeedAt(plan, knots, i);
            var seconds = i == 0 ? 0.0 : Math.Max(ShortestSeconds, 2.0 * (knots[i] - knots[i - 1]) / (speed + rows[^1].Speed));
            rows.Add(new Station(Round(seconds), new Point2D(Round(place.Point.X), Round(place.Point.Y)), new Vector2D(Round(place.Tangent.X * speed), Round(place.Tangent.Y * speed)), speed));
        }

        return rows;
    }

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

    /// <summary>The acceleration of a cubic is linear in time, so that it is greatest at an end; its speed is checked there too.</summary>
    private static void AddLimits(List<string> broken, int element, in Station from, in Station to, TrajectoryMotion motion)
    {
        var (way, t) = (to.Place - from.Place, to.Seconds);
        var first = (way * (6.0 / (t * t))) - (from.Velocity * (4.0 / t)) - (to.Velocity * (2.0 / t));
        var last = (way * (-6.0 / (t * t))) + (from.Velocity * (2.0 / t)) + (to.Velocity * (4.0 / t));
        var most = Math.Max(Math.Max(Math.Abs(first.X), Math.Abs(last.X)), Math.Max(Math.Abs(first.Y), Math.Abs(last.Y)));
        if (most > motion.Acceleration) broken.Add(Wording.Get("Xps.Acceleration", element, Fact(most), Fact(motion.Acceleration)));
        if (to.Velocity.Length > motion.Velocity * 1.000001) broken.Add(Wording.Get("Xps.Velocity", element, Fact(to.Velocity.Length), Fact(motion.Velocity)));
        if (t <= ShortestSeconds && way.Length > 0.0) broken.Add(Wording.Get("Xps.ElementTooShort", element, Fact(t)));
    }

    private static string Fact(double value) => value.ToString("0.####", CultureInfo.InvariantCulture);

    private readonly record struct Station(double Seconds, Point2D Place, Vector2D Velocity, double Speed);
}

/// <summary>Speed along a chain from rest to rest: as fast as asked, slower where the curvature or the ends demand it, never accelerating faster than allowed.</summary>
internal sealed class PvtSpeeds
{
    /// <summary>Part of the acceleration that turning takes; the rest is for speeding up and slowing down.</summary>
    private const double TurningShare = 0.5;

    private double[] _at;
    private double[] _squared;

    public PvtSpeeds(SmoothChain chain, double velocity, double acceleration)
    {
        var (at, squared) = (new List<double>(), new List<double>());
        foreach (var piece in chain.Pieces)
        {
            for (var i = 0; i <= 16; i++)
            {
                var place = piece.At(i / 16.0);
                at.Add(piece.LengthAt(i / 16.0));
                squared.Add(Math.Min(velocity * velocity, TurningShare * acceleration / Math.Max(Math.Abs(place.Curvature), 1e-12)));
            }
        }

        (_at, _squared) = ([.. at], [.. squared]);
        var along = 2.0 * (1.0 - TurningShare) * acceleration;
        var (up, down, half) = (_squared[0] / along, _squared[^1] / along, chain.Length / 2.0);
        Ramps = up < half && down < half ? [up, chain.Length - down] : [half];
        InsertRamps();
        (_squared[0], _squared[^1]) = (0.0, 0.0);
        for (var i = 1; i < _at.Length; i++) _squared[i] = Math.Min(_squared[i], _squared[i - 1] + (along * (_at[i] - _at[i - 1])));
        for (var i = _at.Length - 2; i >= 0; i--) _squared[i] = Math.Min(_squared[i], _squared[i + 1] + (along * (_at[i + 1] - _at[i])));
    }

    /// <summary>Lengths at which the speed of rest has become the speed of travel, and at which it begins to fall.</summary>
    public IReadOnlyList<double> Ramps { get; }

    /// <summary>mm/s at a length.</summary>
    public double At(double length)
    {
        var found = Array.BinarySearch(_at, length);
        if (found >= 0) return Math.Sqrt(_squared[found]);
        var next = Math.Clamp(~found, 1, _at.Length - 1);
        var share = (length - _at[next - 1]) / Math.Max(_at[next] - _at[next - 1], double.Epsilon);
        return Math.Sqrt(_squared[next - 1] + (Math.Clamp(share, 0.0, 1.0) * (_squared[next] - _squared[next - 1])));
    }

    /// <summary>Makes the ends of the ramps places of the table, for the squared speed is linear between its places.</summary>
    private void InsertRamps()
    {
        foreach (var ramp in Ramps)
        {
            var found = Array.BinarySearch(_at, ramp);
            if (found >= 0) continue;
            var next = Math.Clamp(~found, 1, _at.Length - 1);
            var squared = Math.Min(_squared[next - 1], _squared[next]);
            _at = [.. _at[..next], ramp, .. _at[next..]];
            _squared = [.. _squared[..next], squared, .. _squared[next..]];
        }
    }
}
