using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Geometry;

namespace Engraver.TestKit.Programs;

/// <summary>A simple reader of G-code for tests: everything that can be read is followed in plan, without checks.</summary>
public static partial class GcodeLines
{
    /// <summary>Radii that differ by less, mm, are equal, because end points are rounded.</summary>
    private const double SameRadius = 2e-5;

    /// <summary>Number of chords of an arc; for a radius of 100 mm the error is less than a micrometre.</summary>
    private const int Chords = 1000;

    /// <summary>The cuts made while a tool is switched on by M3 or M8; null when a number cannot be read.</summary>
    public static IReadOnlyList<Segment>? Cuts(string text)
    {
        var (cuts, place, motion, unit, isOn) = (new List<Segment>(), default(Point2D), 0, 1.0, false);
        foreach (var row in text.Split('\n').Select(row => Comment().Replace(row.Replace(" ", "", StringComparison.Ordinal), "").ToUpperInvariant()))
        {
            var words = new Dictionary<char, double>();
            foreach (Match word in Word().Matches(row))
            {
                if (!double.TryParse(word.Groups[2].Value, CultureInfo.InvariantCulture, out var value)) return null;
                if (word.Value[0] == 'G' && value is 0.0 or 1.0 or 2.0 or 3.0) motion = (int)value;
                else if (word.Value[0] == 'G') unit = value == 20.0 ? 25.4 : value == 21.0 ? 1.0 : unit;
                else if (word.Value[0] == 'M' && value is 2.0 or 30.0) return cuts;
                else if (word.Value[0] == 'M') isOn = value is 3.0 or 4.0 or 8.0 || (isOn && value is not (5.0 or 9.0));
                else words[word.Value[0]] = value * unit;
            }

            if (!words.ContainsKey('X') && !words.ContainsKey('Y') && !words.ContainsKey('I') && !words.ContainsKey('J')) continue;
            var end = new Point2D(words.GetValueOrDefault('X', place.X), words.GetValueOrDefault('Y', place.Y));
            if (isOn && motion < 2) cuts.Add(Segment.FromLine(place, end));
            else if (isOn) cuts.AddRange(Arc(place, end, new Point2D(place.X + words.GetValueOrDefault('I'), place.Y + words.GetValueOrDefault('J')), motion == 2));
            place = end;
        }

        return cuts;
    }

    /// <summary>Around the centre with a radius that changes evenly from that of the start to that of the end, if they differ slightly (rs274-hpgl.md
    /// 1.3).</summary>
    private static IEnumerable<Segment> Arc(Point2D start, Point2D end, Point2D centre, bool clockwise)
    {
        var (from, to) = ((start - centre).Direction.Degrees, (end - centre).Direction.Degrees);
        var sweep = clockwise ? from - to : to - from;
        sweep = start == end ? 360.0 : sweep <= 0.0 ? sweep + 360.0 : sweep > 360.0 ? sweep - 360.0 : sweep;
        if (clockwise) sweep = -sweep;
        var (first, last) = (centre.DistanceTo(start), centre.DistanceTo(end));
        if (Math.Abs(last - first) < SameRadius) return [Segment.FromArc(new ArcSegment(centre, first, Angle.FromDegrees(from), Angle.FromDegrees(sweep)))];
        Point2D At(int i)
        {
            var (radius, turned) = (first + ((last - first) * i / Chords), (from + (sweep * i / Chords)) * Math.PI / 180.0);
            return new Point2D(centre.X + (radius * Math.Cos(turned)), centre.Y + (radius * Math.Sin(turned)));
        }

        return Enumerable.Range(0, Chords).Select(i => Segment.FromLine(At(i), At(i + 1)));
    }

    [GeneratedRegex(@"\(.*?\)|;.*")]
    private static partial Regex Comment();

    [GeneratedRegex(@"([A-Z])([-+.\d]+)")]
    private static partial Regex Word();
}
