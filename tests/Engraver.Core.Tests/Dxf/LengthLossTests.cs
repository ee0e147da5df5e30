using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>One number inside a curve is changed (a span, a radius, a count): the length of the curve agrees with the changed numbers, or a finding reports a
/// difference.</summary>
public class LengthLossTests
{
    /// <summary>A curve may be shorter than the estimate by this fraction, because sums of chords are too short themselves.</summary>
    private const double Shorter = 1e-3;

    private const int Chords = 2000;

    private static readonly string[] Types = ["ARC", "CIRCLE", "ELLIPSE", "LWPOLYLINE", "POLYLINE", "SPLINE", "HATCH 2", "HATCH 3"];

    [Fact]
    public void No_changed_number_costs_length_in_silence()
    {
        var lost = new List<string>();
        for (var seed = 1; seed <= TestExtent.Cases(perCommit: 400, full: 20_000, "ENGRAVER_LENGTH_CASES"); seed++)
        {
            var random = new Random(seed);
            var pairs = Changed(Curve(Types[seed % Types.Length], random), random);
            var drawing = DxfReading.Of(DxfText.WithEntities(pairs).ToAscii(), new DxfReadOptions(Cut: CutChoice.Hatch));
            var (written, read) = (Written(pairs), SpanTests.Length(drawing));
            if (read < written * (1.0 - Shorter) && drawing.Diagnostics.All(finding => finding.Severity == Severity.Info))
            {
                lost.Add(string.Create(CultureInfo.InvariantCulture, $"seed {seed}: {read} of {written} in {string.Join(' ', pairs.Select(pair => FormattableString.Invariant($"{pair.Code}={pair.Value}")))}"));
            }
        }

        Assert.Empty(lost);
    }

    private static (int Code, object Value)[] Curve(string type, Random random)
    {
        double Size() => Math.Round((random.NextDouble() * 100.0) + 0.1, 3);
        var (radius, start) = (Size(), Math.Round(random.NextDouble() * 300.0, 4));
        var end = random.Next(3) == 0 ? start + 360.0 : Math.Round(random.NextDouble() * 360.0, 4);
        (int, object)[] vertices = [(10, 0.0), (20, 0.0), (42, 0.4), (10, Size()), (20, 1.0), (42, 1.0), (10, Size()), (20, Size() + 2.0)];
        return type switch
        {
            "ARC" => [(0, "ARC"), (10, Size()), (20, Size()), (40, radius), (50, start), (51, end)],
            "CIRCLE" => [(0, "CIRCLE"), (10, Size()), (20, Size()), (40, radius)],
            "ELLIPSE" => [(0, "ELLIPSE"), (10, 0.0), (20, 0.0), (11, radius), (21, Size()), (40, 0.3), (41, start * Math.PI / 180.0), (42, end * Math.PI / 180.0)],
            "LWPOLYLINE" => [(0, "LWPOLYLINE"), (90, 3), (70, random.Next(2)), .. vertices],
            "POLYLINE" => [(0, "POLYLINE"), (66, 1), (70, random.Next(2)), .. vertices.SelectMany<(int Code, object), (int, object)>(pair => pair.Code == 10 ? [(0, "VERTEX"), pair] : [pair]), (0, "SEQEND")],
            "SPLINE" => [(0, "SPLINE"), (70, 8), (71, 3), (72, 8), (73, 4), (74, 0), .. Enumerable.Range(0, 8).Select(i => (40, (object)(i < 4 ? 0.0 : 1.0))), (10, 0.0), (20, 0.0), (10, Size()), (20, 3.0), (10, 7.0), (20, Size()), (10, Size() + 10.0), (20, Size())],
            "HATCH 2" => [(0, "HATCH"), (91, 1), (92, 1), (93, 1), (72, 2), (10, 0.0), (20, 0.0), (40, radius), (50, start), (51, end), (73, random.Next(2)), (97, 0), (75, 0)],
            _ => [(0, "HATCH"), (91, 1), (92, 1), (93, 1), (72, 3), (10, 0.0), (20, 0.0), (11, radius), (21, Size()), (40, 0.3), (50, start), (51, end), (73, random.Next(2)), (97, 0), (75, 0)],
        };
    }

    private static (int Code, object Value)[] Changed((int Code, object Value)[] pairs, Random random)
    {
        var places = Enumerable.Range(0, pairs.Length).Where(i => pairs[i].Code is 41 or 42 or 50 or 51 or 71 or 72 or 73 or 74 or 90 or 91 or 93 || (pairs[i].Code == 40 && pairs[0].Value is not "SPLINE")).ToArray();
        var place = places[random.Next(places.Length)];
        var isHatch = pairs[0].Value is "HATCH";
        if (isHatch && pairs[place].Code is 72 or 73) place = Array.FindIndex(pairs, pair => pair.Code == 51); // the kind and the direction of an edge are flags
        var changed = pairs[place].Value is int count ? (object)Count(count, random) : Number((double)pairs[place].Value, pairs[0].Value is "ELLIPSE" ? Math.Tau : 360.0, random);
        return [.. pairs[..place], (pairs[place].Code, changed), .. pairs[(place + 1)..]];
    }

    private static int Count(int count, Random random) => random.Next(4) switch { 0 => count + 1, 1 => Math.Max(0, count - 1), 2 => 0, _ => count * 1000 };

    private static double Number(double value, double turn, Random random) => random.Next(10) switch
    {
        0 => Math.Round(value, random.Next(0, 4)),
        1 => Math.Round(value + turn, random.Next(2, 9)),
        2 => value + (random.Next(1, 4) * turn) + Math.Pow(10.0, -random.Next(2, 12)),
        3 => value - turn,
        4 => Math.Round(value - turn, random.Next(2, 9)),
        5 => -value,
        6 => value * Math.Pow(10.0, random.Next(-9, 10)),
        7 => value + Math.Pow(10.0, -random.Next(4, 12)),
        8 => 0.0,
        _ => value * random.NextDouble(),
    };

    /// <summary>From the definitions of the curves, by many chords; for a spline the path from its first control point to its last.</summary>
    private static double Written((int Code, object Value)[] pairs)
    {
        double At(int code, double otherwise = 0.0) => pairs.FirstOrDefault(pair => pair.Code == code && pair.Value is double) is { Value: double value } ? value : otherwise;
        var (major, ratio) = (double.Hypot(At(11), At(21)), At(40));
        switch ((string)pairs[0].Value)
        {
            case "CIRCLE":
                return Math.Tau * Math.Abs(At(40));
            case "ARC" or "HATCH" when major == 0.0:
                return Math.Abs(At(40)) * Turn(At(50), At(51), 360.0) * Math.PI / 180.0;
            case "ELLIPSE":
                return Along(At(41), Turn(At(41), At(42), Math.Tau), a => (major * Math.Cos(a), major * ratio * Math.Sin(a)));
            case "HATCH":
                return ratio == 0.0 ? 0.0 : Along(At(50) * Math.PI / 180.0, Turn(At(50), At(51), 360.0) * Math.PI / 180.0, a => OnRay(major, ratio, a));
            case "SPLINE":
                var last = pairs.Where(pair => pair.Code is 10 or 20).Select(pair => (double)pair.Value).TakeLast(2).ToArray();
                return double.Hypot(last[0], last[1]);
            default:
                return Polyline(pairs);
        }
    }

    private static (double X, double Y) OnRay(double major, double ratio, double angle)
    {
        var reach = 1.0 / double.Hypot(Math.Cos(angle) / major, Math.Sin(angle) / (major * ratio));
        return (reach * Math.Cos(angle), reach * Math.Sin(angle));
    }

    /// <summary>At most a turn. An end angle below the start angle is reached after the angles have started again; a nearly empty span is meant only by two
    /// angles near that point.</summary>
    private static double Turn(double start, double end, double turn)
    {
        if (Math.Abs(end - start) <= 1e-9) return 0.0;
        if (end > start) return Math.Min(end - start, turn);
        var ahead = end - start - (turn * Math.Floor((end - start) / turn));
        var usual = (end >= 0.0 && start <= turn) || (end >= -turn / 2.0 && start <= turn / 2.0);
        return ahead <= 1e-9 || (ahead < 1e-6 && !usual) ? turn : ahead;
    }

    private static double Along(double start, double span, Func<double, (double X, double Y)> place)
    {
        var (sum, last) = (0.0, place(start));
        for (var i = 1; i <= Chords; i++)
        {
            var next = place(start + (span * i / Chords));
            sum += double.Hypot(next.X - last.X, next.Y - last.Y);
            last = next;
        }

        return sum;
    }

    private static double Polyline((int Code, object Value)[] pairs)
    {
        var vertices = new List<(double X, double Y, double Bulge)>();
        foreach (var (code, value) in pairs)
        {
            if (code == 10) vertices.Add(((double)value, 0.0, 0.0));
            else if (code == 20) vertices[^1] = vertices[^1] with { Y = (double)value };
            else if (code == 42) vertices[^1] = vertices[^1] with { Bulge = (double)value };
        }

        var isClosed = pairs.Any(pair => pair.Code == 70 && pair.Value is 1);
        return Enumerable.Range(0, isClosed ? vertices.Count : vertices.Count - 1).Sum(i => Bulged(vertices[i], vertices[(i + 1) % vertices.Count]));
    }

    private static double Bulged((double X, double Y, double Bulge) from, (double X, double Y, double Bulge) to)
    {
        var (chord, quarter) = (double.Hypot(to.X - from.X, to.Y - from.Y), Math.Atan(Math.Abs(from.Bulge)));
        return quarter < 1e-6 ? chord : chord / Math.Sin(2.0 * quarter) * 2.0 * quarter;
    }
}
