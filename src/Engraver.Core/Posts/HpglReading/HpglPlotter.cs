using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts.HpglReading;

/// <summary>A plotter as defined by the language: a pen that is up or down at a position in millimetres, the frame of the numbers, and a speed. The reported
/// time only gives the order.</summary>
internal sealed class HpglPlotter(ReplayRequest request)
{
    private const double PlotterUnit = 0.025;
    private const double UsualChord = 5.0;

    /// <summary>Resolution of a speed written with four decimals of cm/s, mm/min.</summary>
    private const double SpeedQuantum = 0.06;

    /// <summary>Scale and zero of the numbers in millimetres, along each axis.</summary>
    private (double ScaleX, double ScaleY, double ZeroX, double ZeroY) _frame = (PlotterUnit, PlotterUnit, 0.0, 0.0);
    private (double X1, double Y1, double X2, double Y2)? _corners;
    private Point2D _place;
    private bool _isInitialised;
    private int _pen;
    private bool _isAbsolute = true;
    private double? _speed;
    private double _seconds;

    public bool HasMoved { get; private set; }

    /// <summary>The pen is on the sheet.</summary>
    public bool IsDown { get; private set; }

    /// <returns>The reason why the command cannot be executed; null when it was executed.</returns>
    public string? Execute(HpglCommand command)
    {
        var values = command.Values;
        if (!_isInitialised && command.Name != "IN") return Wording.Get("HpglReader.NotInitialised");
        switch (command.Name, values.Count)
        {
            case ("IN", 0):
                (_isInitialised, _pen, _isAbsolute, IsDown) = (true, 0, true, false);
                (_frame, _corners) = ((PlotterUnit, PlotterUnit, 0.0, 0.0), null);
                return null;
            case ("SP", 0 or 1): return Select(values.Count == 0 ? 0.0 : values[0]);
            case ("VS", 1 or 2): return Speed(values);
            case ("IP", 4): return Corners(values);
            case ("SC", 4): return Scale(values);
            case ("PU" or "PD" or "PA" or "PR", _): return Plot(command);
            case ("AA" or "AR", 3 or 4): return Arc(command);
            default: return Wording.Get("HpglReader.CommandNotSupported", command.Name, values.Count);
        }
    }

    private string? Select(double pen)
    {
        if (pen is not (>= 0.0 and <= 8.0) || pen != Math.Floor(pen)) return Wording.Get("HpglReader.PenNotValid", pen);
        if (IsDown && pen == 0.0) return Wording.Get("HpglReader.EndsWithPenDown");
        _pen = (int)pen;
        return null;
    }

    /// <summary>Applies to every pen, or to the pen that is named after it.</summary>
    private string? Speed(IReadOnlyList<double> values)
    {
        if (!(values[0] > 0.0)) return Wording.Get("HpglReader.SpeedNotPositive", values[0]);
        if (values.Count == 1 || values[1] == (request.Strokes is null ? request.Requirements?.Required.Pen ?? _pen : _pen)) _speed = values[0] * 600.0;
        return null;
    }

    private string? Corners(IReadOnlyList<double> values)
    {
        if (values[0] == values[2] || values[1] == values[3]) return Wording.Get("HpglReader.ScaleNotUsable");
        _corners = (values[0], values[1], values[2], values[3]);
        return null;
    }

    /// <summary>SC assigns numbers to the corners of IP. Without IP the corners depend on the device, and the program does not state them.</summary>
    private string? Scale(IReadOnlyList<double> values)
    {
        if (_corners is not { } corners || values[0] == values[1] || values[2] == values[3]) return Wording.Get("HpglReader.ScaleNotUsable");
        if (HasMoved) return Wording.Get("HpglReader.ScaleAfterMove");
        var (x, y) = ((corners.X2 - corners.X1) * PlotterUnit / (values[1] - values[0]), (corners.Y2 - corners.Y1) * PlotterUnit / (values[3] - values[2]));
        _frame = (x, y, (corners.X1 * PlotterUnit) - (values[0] * x), (corners.Y1 * PlotterUnit) - (values[2] * y));
        return null;
    }

    private string? Plot(HpglCommand command)
    {
        if (command.Name is "PU" or "PD")
        {
            var was = IsDown;
            IsDown = command.Name == "PD";
            if (IsDown && _pen == 0) return Wording.Get("HpglReader.NoPenSelected");
            if (was != IsDown) Dwell();
        }
        else
        {
            _isAbsolute = command.Name == "PA";
        }

        if (command.Values.Count % 2 != 0) return Wording.Get("HpglReader.PairsNeeded", command.Name);
        for (var i = 0; i < command.Values.Count; i += 2) GoTo(Place(command.Values[i], command.Values[i + 1], _isAbsolute), command.Line);
        return null;
    }

    /// <summary>An arc about a centre from the pen position, as the chords that the plotter draws: equal chords of at most the chord angle.</summary>
    private string? Arc(HpglCommand command)
    {
        var (values, chord) = (command.Values, command.Values.Count == 4 ? command.Values[3] : UsualChord);
        if (chord is not (>= 0.5 and <= 180.0)) return Wording.Get("HpglReader.BadChordAngle", chord);
        if (Math.Abs(values[2]) is not (> 0.0 and <= 360.0)) return Wording.Get("HpglReader.BadSweep", values[2]);
        if (Math.Abs(Math.Abs(_frame.ScaleX) - Math.Abs(_frame.ScaleY)) > 1e-12 || _frame.ScaleX * _frame.ScaleY < 0.0) return Wording.Get("HpglReader.ScaleNotUsable");
        var centre = Place(values[0], values[1], command.Name == "AA");
        var (x, y) = (_place.X - centre.X, _place.Y - centre.Y);
        var count = (int)Math.Ceiling(Math.Abs(values[2]) / chord);
        for (var i = 1; i <= count; i++)
        {
            var (sine, cosine) = Math.SinCos(values[2] * Math.PI / 180.0 * i / count);
            GoTo(new Point2D(centre.X + (x * cosine) - (y * sine), centre.Y + (x * sine) + (y * cosine)), command.Line);
        }

        return null;
    }

    private Point2D Place(double x, double y, bool absolute) => absolute
        ? new Point2D(_frame.ZeroX + (x * _frame.ScaleX), _frame.ZeroY + (y * _frame.ScaleY))
        : new Point2D(_place.X + (x * _frame.ScaleX), _place.Y + (y * _frame.ScaleY));

    private void GoTo(Point2D to, int line)
    {
        var from = _place;
        (_place, HasMoved) = (to, true);
        if (!IsDown) Dwell();
        else if (from != to) Draw(Segment.FromLine(from, to), line);
    }

    private void Draw(in Segment path, int line)
    {
        foreach (var judge in request.Judges) judge.Add(new TraceSpan(_seconds, _seconds + 1.0, 2, path, Cutting: true));
        _seconds += 1.0;
        var strokes = request.Strokes?.Passing(path.End, null);
        Judge(line, strokes);
        if (_speed is { } speed) request.Feeds?.Add(line, speed, path.Length, quantum: SpeedQuantum, strokes: strokes);
    }

    /// <summary>Checks for the requested pen and for a stated speed: the default speed of a plotter can be any.</summary>
    /// <param name="strokes">The strokes that may be drawn, each by the pen of its tool; null or empty: unknown.</param>
    private void Judge(int line, IReadOnlyList<StrokeRequirement>? strokes)
    {
        if (request.Requirements is not { } terms) return;
        if (strokes is { Count: > 0 } ? !strokes.Any(stroke => stroke.Tool == _pen) : request.Strokes is null && _pen != terms.Required.Pen) terms.AddDifference(line, $"SP{_pen}", $"SP{strokes?[0].Tool ?? terms.Required.Pen}");
        if (_speed is null) terms.AddDifference(line, Wording.Get("HpglReader.NoSpeed"), "VS");
    }

    /// <summary>Called at the end of the program: a pen that stays in the holder dries up.</summary>
    public void End(int line)
    {
        if (_pen != 0) request.Requirements?.AddDifference(line, $"SP{_pen}", "SP0");
    }

    private void Dwell()
    {
        _seconds += 1.0;
        foreach (var judge in request.Judges) judge.Add(new TraceSample(_seconds, _place.X, _place.Y, IsDown));
    }
}
