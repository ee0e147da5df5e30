using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Geometry;

namespace Engraver.TestKit.Programs;

/// <summary>A simple reader of HP-GL for tests: everything that can be read is followed, without checks. Arcs are kept as arcs, not as chords.</summary>
public static partial class HpglLines
{
    /// <summary>The lines drawn by the pen, millimetres; null when a number cannot be read.</summary>
    public static IReadOnlyList<Segment>? Cuts(string text)
    {
        var (cuts, place, isDown, isAbsolute, corner, unit) = (new List<Segment>(), default(Point2D), false, true, 4000.0, 0.025);
        foreach (Match command in Command().Matches(text))
        {
            var words = command.Groups[2].Value.Split(',', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);
            if (!words.All(word => double.TryParse(word, CultureInfo.InvariantCulture, out _))) return null;
            var values = words.Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray();
            var name = command.Groups[1].Value.ToUpperInvariant();
            if (name is "PU" or "PD") isDown = name == "PD";
            else if (name is "PA" or "PR") isAbsolute = name == "PA";
            else if (name == "IP" && values.Length == 4) corner = values[2] - values[0];
            else if (name == "SC" && values.Length == 4) unit = corner * 0.025 / (values[1] - values[0]);
            if (name is "PU" or "PD" or "PA" or "PR")
            {
                for (var i = 0; i + 1 < values.Length; i += 2)
                {
                    var to = isAbsolute ? new Point2D(values[i] * unit, values[i + 1] * unit) : place + new Vector2D(values[i] * unit, values[i + 1] * unit);
                    if (isDown) cuts.Add(Segment.FromLine(place, to));
                    place = to;
                }
            }
            else if (name == "AA" && values.Length >= 3)
            {
                var centre = new Point2D(values[0] * unit, values[1] * unit);
                var arc = Segment.FromArc(new ArcSegment(centre, centre.DistanceTo(place), (place - centre).Direction, Angle.FromDegrees(values[2])));
                if (isDown) cuts.Add(arc);
                place = arc.End;
            }
        }

        return cuts;
    }

    [GeneratedRegex(@"([A-Za-z]{2})([^A-Za-z;]*)")]
    private static partial Regex Command();
}
