using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Geometry;

namespace Engraver.TestKit.Programs;

/// <summary>G-code as a test reads it: whatever can be read is followed in plan, nothing is checked.</summary>
public static partial class GcodeLines
{
    /// <summary>What is cut while a tool is switched on by M3 or M8; null when a number cannot be read.</summary>
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
            else if (isOn) cuts.Add(Arc(place, end, new Point2D(place.X + words.GetValueOrDefault('I'), place.Y + words.GetValueOrDefault('J')), motion == 2));
            place = end;
        }

        return cuts;
    }

    private static Segment Arc(Point2D start, Point2D end, Point2D centre, bool clockwise)
    {
        var (from, to) = ((start - centre).Direction.Degrees, (end - centre).Direction.Degrees);
        var sweep = clockwise ? from - to : to - from;
        sweep = start == end ? 360.0 : sweep <= 0.0 ? sweep + 360.0 : sweep > 360.0 ? sweep - 360.0 : sweep;
        return Segment.FromArc(new ArcSegment(centre, centre.DistanceTo(start), Angle.FromDegrees(from), Angle.FromDegrees(clockwise ? -sweep : sweep)));
    }

    [GeneratedRegex(@"\(.*?\)|;.*")]
    private static partial Regex Comment();

    [GeneratedRegex(@"([A-Z])([-+.\d]+)")]
    private static partial Regex Word();
}
