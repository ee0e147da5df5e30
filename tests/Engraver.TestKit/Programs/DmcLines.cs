using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.TestKit.Programs;

/// <summary>A simple reader of DMC programs for tests: statement by statement, motion in plan and switching of output 1, with calls and variables; everything
/// else is skipped, without checks.</summary>
public sealed class DmcLines
{
    private const int MaxStatements = 200_000;

    /// <summary>Time in which a machine from rest moves three counts, seconds.</summary>
    private const double MinMotion = 0.008;

    private readonly List<(string Label, string Text)> _statements = [];
    private readonly Dictionary<string, double> _variables = [];
    private readonly List<Segment> _cuts = [];
    private readonly List<Segment> _sequence = [];
    private Point2D _place;
    private Point2D _from;
    private Point2D _vector;
    private double? _toX;
    private double? _toY;
    private bool _isOn;
    private readonly List<(string Name, double Value)> _actions = [];
    /// <summary>Speeds and accelerations; until a program sets them, those of power-on (galil-dmc.md C).</summary>
    private readonly Dictionary<string, double> _set = new() { ["VS"] = 25000, ["VA"] = 256000, ["VD"] = 256000, ["SPA"] = 25000, ["SPB"] = 25000, ["ACA"] = 256000, ["ACB"] = 256000, ["DCA"] = 256000, ["DCB"] = 256000 };
    private double _waited;

    /// <summary>The cuts, millimetres at 1000 counts; null when a number cannot be read or the program does not end.</summary>
    public static IReadOnlyList<Segment>? Cuts(string text) => Read(text)?._cuts;

    /// <summary>Every move with its duration at the present speeds and accelerations, and the waits of the program before it; a wait after the last move is
    /// ignored. Null as above.</summary>
    public static IReadOnlyList<(string Name, double Value)>? Actions(string text) => Read(text)?._actions;

    private static DmcLines? Read(string text)
    {
        var run = new DmcLines();
        foreach (var line in text.Split('\n').Where(line => !line.StartsWith('\'')))
        {
            if (line.StartsWith('#')) run._statements.Add((line.Trim(), ""));
            else foreach (var one in line.Split(';')) run._statements.Add(("", one.Trim()));
        }

        return run.Run() ? run : null;
    }

    private bool Run()
    {
        var (calls, at) = (new Stack<int>(), 0);
        for (var count = 0; at < _statements.Count && count < MaxStatements; count++)
        {
            var text = _statements[at++].Text;
            if (text == "EN" && calls.Count == 0) return true;
            if (text == "EN") at = calls.Pop();
            else if (text.StartsWith("JS#", StringComparison.Ordinal))
            {
                calls.Push(at);
                at = _statements.FindIndex(one => one.Label == text[2..]);
                if (at < 0) return false;
            }
            else if (!Execute(text))
            {
                return false;
            }
        }

        return at >= _statements.Count;
    }

    private bool Execute(string text)
    {
        if (text.Length > 2 && text[..2] is "VP" or "CR" or "VS" or "VA" or "VD" or "WT" && text[2] is not (' ' or '=')) text = text.Insert(2, " "); // the blank is ignored
        if (text is "SB1" or "CB1") _isOn = text == "SB1";
        else if (text == "VMAB") (_from, _vector) = (_place, default);
        else if (text.StartsWith("VP ", StringComparison.Ordinal) && Values(Unpaced(text[3..])) is [var x, var y]) Add(Segment.FromLine(_vector, new Point2D(x, y)));
        else if (text.StartsWith("CR ", StringComparison.Ordinal) && Values(Unpaced(text[3..])) is [var radius, var theta, var sweep]) Add(Segment.FromArc(new ArcSegment(_vector - Vector2D.FromPolar(radius, Angle.FromDegrees(theta)), radius, Angle.FromDegrees(theta), Angle.FromDegrees(sweep))));
        else if (text.StartsWith("WT ", StringComparison.Ordinal)) return Value(text[3..]) is { } wait && Wait(wait);
        else if (text.Length > 3 && text[..3] is "VS " or "VA " or "VD ") return Value(text[3..]) is { } speed && Keep(text[..2], speed);
        else if (text.Length > 4 && text[3] == '=' && text[..2] is "SP" or "AC" or "DC") return Value(text[4..]) is { } rate && Keep(text[..3], rate);
        else if (text.StartsWith("BG", StringComparison.Ordinal)) Begin(text[2..]);
        else if (text.StartsWith("PAA=", StringComparison.Ordinal)) _toX = Value(text[4..]);
        else if (text.StartsWith("PAB=", StringComparison.Ordinal)) _toY = Value(text[4..]);
        else if (text.IndexOf('=', StringComparison.Ordinal) is > 0 and var equals && char.IsAsciiLetterLower(text[0])) return Value(text[(equals + 1)..]) is { } value && Set(text[..equals], value);
        else return !text.StartsWith("VP", StringComparison.Ordinal) && !text.StartsWith("CR", StringComparison.Ordinal);
        return true;
    }

    /// <summary>The numbers of a segment without its speed, which is kept.</summary>
    private string Unpaced(string segment)
    {
        var parts = segment.Split('<');
        if (parts.Length > 1) _set["<"] = Value(parts[1]) ?? double.NaN;
        return parts[0];
    }

    private bool Wait(double milliseconds)
    {
        _waited += milliseconds / 1000.0;
        return true;
    }

    private bool Keep(string name, double value)
    {
        _set[name] = value;
        return true;
    }

    private void Move(double seconds)
    {
        if (!(seconds > MinMotion)) return; // within the tolerance of a position
        _actions.Add(("rest", _waited));
        _actions.Add(("move", seconds));
        _waited = 0.0;
    }

    /// <summary>Up to the speed and down again, or as far up as the length allows.</summary>
    private double Seconds(double length, string speed, string up, string down)
    {
        var (v, a, d) = (_set.GetValueOrDefault(speed, double.NaN), _set.GetValueOrDefault(up, double.NaN), _set.GetValueOrDefault(down, double.NaN));
        if (length == 0.0) return 0.0;
        var top = Math.Min(v, Math.Sqrt(2.0 * length * a * d / (a + d)));
        return (top / a) + (top / d) + ((length - (top * top / 2.0 * ((1.0 / a) + (1.0 / d)))) / top);
    }

    private void Begin(string axes)
    {
        if (axes.Contains('S', StringComparison.Ordinal)) Move(Seconds(_sequence.Sum(run => run.Length), "VS", "VA", "VD"));
        else Move(Math.Max(axes.Contains('A', StringComparison.Ordinal) && _toX is { } alongX ? Seconds(Math.Abs(alongX - _place.X), "SPA", "ACA", "DCA") : 0.0, axes.Contains('B', StringComparison.Ordinal) && _toY is { } alongY ? Seconds(Math.Abs(alongY - _place.Y), "SPB", "ACB", "DCB") : 0.0));
        if (axes.Contains('S', StringComparison.Ordinal)) Go();
        _place = new Point2D(axes.Contains('A', StringComparison.Ordinal) && _toX is { } x ? x : _place.X, axes.Contains('B', StringComparison.Ordinal) && _toY is { } y ? y : _place.Y);
    }

    private bool Set(string name, double value)
    {
        _variables[name] = value;
        return true;
    }

    private void Add(Segment run)
    {
        _sequence.Add(run);
        _vector = run.End;
    }

    private void Go()
    {
        var shift = _from - default(Point2D);
        foreach (var run in _sequence.Where(_ => _isOn)) _cuts.Add(Millimetres(run, shift));
        _place = _vector + shift;
        _sequence.Clear();
    }

    private static Segment Millimetres(Segment run, Vector2D shift)
    {
        Point2D Moved(Point2D place) => new((place.X + shift.X) / 1000.0, (place.Y + shift.Y) / 1000.0);
        return run.Kind == SegmentKind.Line ? Segment.FromLine(Moved(run.Start), Moved(run.End)) : Segment.FromArc(new ArcSegment(Moved(run.Arc.Centre), run.Arc.Radius / 1000.0, run.Arc.Start, run.Arc.Sweep));
    }

    private double[]? Values(string words) => words.Split(',').Select(Value).ToArray() is var values && values.All(value => value is not null) ? [.. values.Select(value => value!.Value)] : null;

    /// <summary>Numbers and variables with + and - between them; the position of the machine is 0.</summary>
    private double? Value(string words)
    {
        var (sum, sign, term) = (0.0, 1.0, "");
        foreach (var letter in words + "+")
        {
            if (letter is not ('+' or '-') || (letter == '-' && term.Length == 0))
            {
                if (letter == '-' && term.Length == 0) sign = -sign;
                else term += letter;
                continue;
            }

            if (term.StartsWith("_RP", StringComparison.Ordinal)) term = "0";
            if (!double.TryParse(term, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) && !_variables.TryGetValue(term, out value)) return null;
            (sum, sign, term) = (sum + (sign * value), letter == '-' ? -1.0 : 1.0, "");
        }

        return sum;
    }
}
