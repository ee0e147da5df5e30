using System.Globalization;
using System.Text.RegularExpressions;

namespace Engraver.TestKit.Programs;

/// <summary>The actions of a program other than the positions of its cuts, in order, as a simple reader for tests finds them: tool, frame, speeds, waits, pen,
/// heights, times. Nothing is checked; a state is listed when it changes.</summary>
public static partial class ProgramActions
{
    /// <summary>Allowed relative difference of a feed or a time, and allowed difference of any number.</summary>
    private const double Share = 0.011;
    private const double FeedShare = 0.0011;
    private const double Exactly = 1.5e-4;

    /// <summary>Feed of the usual machine, mm/s: a fraction of it is the allowed difference of a speed anywhere on the ramp.</summary>
    private const double FeedOfSamples = 20.0;

    /// <summary>Allowed additional time of a wait or a move on a controller, for the statements around it; seconds.</summary>
    private const double Statements = 0.03;

    /// <summary>The actions; null for a program that cannot be read.</summary>
    public static IReadOnlyList<(string Name, double Value)>? Of(string text, string target) => target switch
    {
        "gcode" => Gcode(text),
        "hpgl" => Hpgl(text),
        "xps-linearc" => LineArc(text),
        "xps-spline" => Rows(text, row => row.Length == 3 ? [("height", row[2])] : []),
        "xps-pvt" => Rows(text, row => row.Length == 5 ? [("seconds", row[0]), ("speed", double.Hypot(row[2], row[4]))] : []),
        "galil" or "galil-calls" => DmcLines.Actions(text),
        _ => [],
    };

    /// <summary>True when the actions are the same, each within its allowed difference.</summary>
    public static bool AreSame(IReadOnlyList<(string Name, double Value)> good, IReadOnlyList<(string Name, double Value)>? other) =>
        other is not null && good.Count == other.Count && good.Zip(other).All(pair => pair.First.Name == pair.Second.Name && IsNear(pair.First.Name, pair.First.Value, pair.Second.Value));

    /// <summary>The first difference of the actions, for the message of a test.</summary>
    public static string FirstOther(IReadOnlyList<(string Name, double Value)> good, IReadOnlyList<(string Name, double Value)>? other)
    {
        if (other is null) return "cannot be read";
        var at = good.Zip(other).TakeWhile(pair => AreSame([pair.First], [pair.Second])).Count();
        return string.Create(CultureInfo.InvariantCulture, $"act {at} of {good.Count} and {other.Count}: {good.Skip(at).FirstOrDefault()} and {other.Skip(at).FirstOrDefault()}");
    }

    private static bool IsNear(string name, double good, double other) => Math.Abs(good - other) <= name switch
    {
        "feed" => FeedShare * good,
        "seconds" => (Share * good) + 1e-9,
        "move" => (Share * good) + 0.005,
        "rest" => (Share * good) + Statements,
        "speed" => 2.0 * Share * FeedOfSamples,
        "tangent" => 0.02,
        _ => Exactly,
    };

    private static List<(string Name, double Value)>? Gcode(string text)
    {
        var acts = new ActionList();
        var (motion, feed, tool, waited) = (0, 0.0, 5.0, 0.0);
        foreach (var row in text.Split('\n').Select(row => Comment().Replace(row.Replace(" ", "", StringComparison.Ordinal), "").ToUpperInvariant()))
        {
            var (moves, waits, wait) = (false, false, 0.0);
            foreach (Match word in Word().Matches(row))
            {
                if (!double.TryParse(word.Groups[2].Value, CultureInfo.InvariantCulture, out var value)) return null;
                switch (word.Value[0])
                {
                    case 'F': feed = value; break;
                    case 'S': acts.Is("S", value); break;
                    case 'P': wait = value; break;
                    case 'G' when value == 4.0: waits = true; break;
                    case 'G' when value is >= 0.0 and <= 3.0: motion = (int)value; break;
                    case 'G' when value is >= 54.0 and < 60.0: acts.Is("frame", value); break;
                    case 'G' when value is >= 61.0 and < 65.0: acts.Is("path", value); break;
                    case 'M' when value is 2.0 or 30.0:
                        acts.Then("wait", waited);
                        acts.Is("tool", 5.0);
                        return acts.All;
                    case 'M' when value == 48.0: break; // the operator may override, as always
                    case 'M':
                        if (value != tool) acts.Then("wait", waited);
                        if (value != tool) waited = 0.0;
                        acts.Is("tool", tool = value);
                        break;
                    case 'X' or 'Y' or 'Z' or 'I' or 'J': moves = true; break;
                }
            }

            if (waits) waited += wait;
            if (!moves) continue;
            acts.Then("wait", waited);
            waited = 0.0;
            acts.Is("rapid", motion == 0 ? 1.0 : 0.0);
            if (motion > 0) acts.Is("feed", feed);
        }

        return null;
    }

    private static List<(string Name, double Value)>? Hpgl(string text)
    {
        var (acts, pen, speed, isDown) = (new ActionList(), 0.0, 0.0, false);
        foreach (Match command in Command().Matches(text))
        {
            var words = command.Groups[2].Value.Split(',', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);
            if (!words.All(word => double.TryParse(word, CultureInfo.InvariantCulture, out _))) return null;
            var first = words.Length > 0 ? double.Parse(words[0], CultureInfo.InvariantCulture) : 0.0;
            var name = command.Groups[1].Value.ToUpperInvariant();
            if (name == "SP") pen = first;
            else if (name == "VS") speed = first;
            else if (name is "PU" or "PD") isDown = name == "PD";
            if (!isDown || words.Length == 0) continue;
            acts.Is("pen", pen);
            acts.Is("feed", speed);
        }

        acts.Is("pen", pen);
        return acts.All;
    }

    /// <summary>A first line defines its own direction, and that of a first arc follows from the path. The allowed turn has no effect while it is larger than
    /// the turns: only whether it is larger matters.</summary>
    private static List<(string Name, double Value)>? LineArc(string text)
    {
        var (acts, tangent) = (new ActionList(), (double?)null);
        foreach (var row in text.Split('\n').Select(row => row.Split(';')[0].Split('=')))
        {
            var key = row[0].Trim();
            if (key is "Line" && tangent is { } first) acts.Then("tangent", first, always: true);
            if (key is "Line" or "Arc") tangent = null;
            if (key is not ("FirstTangent" or "DiscontinuityAngle")) continue;
            if (!double.TryParse(row[^1], CultureInfo.InvariantCulture, out var value)) return null;
            if (key == "FirstTangent") tangent = ((value % 360.0) + 360.0) % 360.0;
            else acts.Then("turns", value is >= 0.01 and <= 0.5 ? 1.0 : 0.0, always: true);
        }

        return acts.All;
    }

    private static List<(string Name, double Value)>? Rows(string text, Func<double[], IEnumerable<(string, double)>> acts)
    {
        var all = new List<(string, double)>();
        foreach (var row in text.Split('\n').Select(row => row.Split(';')[0]).Where(row => row.Trim().Length > 0))
        {
            var numbers = row.Split(',').Select(word => double.TryParse(word, CultureInfo.InvariantCulture, out var value) ? value : double.NaN).ToArray();
            if (numbers.Any(double.IsNaN)) return null;
            all.AddRange(acts(numbers));
        }

        return all;
    }

    [GeneratedRegex(@"\(.*?\)|;.*")]
    private static partial Regex Comment();

    [GeneratedRegex(@"([A-Z])([-+.\d]+)")]
    private static partial Regex Word();

    [GeneratedRegex(@"([A-Za-z]{2})([^A-Za-z;]*)")]
    private static partial Regex Command();

    /// <summary>A list to which a state is added when it changes.</summary>
    private sealed class ActionList
    {
        private readonly Dictionary<string, double> _states = [];

        public List<(string Name, double Value)> All { get; } = [];

        public void Is(string name, double value)
        {
            if (_states.TryGetValue(name, out var now) && now == value) return;
            _states[name] = value;
            All.Add((name, value));
        }

        public void Then(string name, double value, bool always = false)
        {
            if (always || value != 0.0) All.Add((name, value));
        }
    }
}
