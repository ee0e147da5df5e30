using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Posts;
using Engraver.Core.Verification;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>Reads trajectory files back and runs them as their controller does, from what is known of the controller alone (sace-xps-agie.md 2); shares no code with what wrote them.</summary>
/// <remarks>Several files are one text: each follows a line <c>; trajectory X Y</c>, the place where the machine stands when it is started. Without that line it stands where the request says.</remarks>
public sealed class TrajectoryReader(ControllerLanguage language) : IProgramReader
{
    /// <summary>What stands before a file.</summary>
    public const string Mark = "; trajectory ";

    /// <summary>A chord of a cubic leaves it by no more, millimetres.</summary>
    private const double ChordError = 1e-6;

    private const int MostChords = 1024;

    public bool TellsHeights => false;

    public Task<IReadOnlyList<Diagnostic>> ReplayAsync(string text, ReplayRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(request);
        var teller = new Teller(request.Judges);
        var start = request.Machine.Scale.ToMillimetres(request.Start.X, request.Start.Y);
        var (rows, faults) = (new List<(int Line, string Text)>(), new List<Diagnostic>());
        var number = 0;
        foreach (var line in text.Split('\n'))
        {
            cancellation.ThrowIfCancellationRequested();
            number++;
            if (line.StartsWith(Mark, StringComparison.Ordinal))
            {
                if (rows.Count > 0) faults.AddRange(Run(rows, start, teller));
                rows.Clear();
                if (Numbers(line[Mark.Length..].Replace(' ', ',')) is [var x, var y]) start = new Point2D(x, y);
                else faults.Add(Unreadable(number, line));
            }
            else if (line.Split(';')[0].Trim() is { Length: > 0 } words)
            {
                rows.Add((number, words));
            }
        }

        if (rows.Count > 0) faults.AddRange(Run(rows, start, teller));
        else if (faults.Count == 0) faults.Add(VerificationRules.ProgramEmpty.At(default));
        return Task.FromResult<IReadOnlyList<Diagnostic>>(faults);
    }

    private IEnumerable<Diagnostic> Run(List<(int Line, string Text)> rows, Point2D start, Teller teller) => language switch
    {
        ControllerLanguage.AbsoluteSpline => RunSpline(rows, default, teller),
        ControllerLanguage.RelativeSpline => RunSpline(rows, start, teller),
        ControllerLanguage.LineArc => RunLineArc(rows, start, teller),
        _ => RunPvt(rows, start, teller),
    };

    /// <summary>The first and the last row only turn the ends; between the others u runs from 0 to 1 through 1/2 (2 p1 + (p2 - p0) u + (2 p0 - 5 p1 + 4 p2 - p3) u^2 + (3 p1 - p0 - 3 p2 + p3) u^3).</summary>
    private IEnumerable<Diagnostic> RunSpline(List<(int Line, string Text)> rows, Point2D start, Teller teller)
    {
        var points = new List<Point2D>();
        foreach (var (line, words) in rows)
        {
            if (Numbers(words) is not [var x, var y, _]) return [Unreadable(line, words)];
            points.Add(new Point2D(start.X + x, start.Y + y));
        }

        if (points.Count < 4) return [TrajectoryRules.LineUnreadable.At(default, Place(rows[^1].Line), Wording.Get("Xps.TooFewLines"))];
        if (language == ControllerLanguage.RelativeSpline && points[1] != start) return [TrajectoryRules.LineUnreadable.At(default, Place(rows[1].Line), Wording.Get("Xps.StartNotZero"))];
        teller.GoTo(points[1]);
        for (var i = 1; i + 2 < points.Count; i++)
        {
            var (a, b, c, d) = (points[i - 1], points[i], points[i + 1], points[i + 2]);
            var leaving = (X: (2.0 * a.X) - (5.0 * b.X) + (4.0 * c.X) - d.X, Y: (2.0 * a.Y) - (5.0 * b.Y) + (4.0 * c.Y) - d.Y);
            var arriving = (X: (2.0 * d.X) - (5.0 * c.X) + (4.0 * b.X) - a.X, Y: (2.0 * d.Y) - (5.0 * c.Y) + (4.0 * b.Y) - a.Y);
            var chords = ChordsOf(leaving, arriving);
            for (var k = 1; k <= chords; k++)
            {
                var u = (double)k / chords;
                double On(double p0, double p1, double p2, double p3) => ((2.0 * p1) + (u * ((p2 - p0) + (u * ((2.0 * p0) - (5.0 * p1) + (4.0 * p2) - p3 + (u * ((3.0 * p1) - p0 - (3.0 * p2) + p3))))))) / 2.0;
                teller.LineTo(k == chords ? c : new Point2D(On(a.X, b.X, c.X, d.X), On(a.Y, b.Y, c.Y, d.Y)));
            }
        }

        return [];
    }

    /// <summary>A line goes to a place counted from the start; an arc goes on in the direction of the element before.</summary>
    private static IEnumerable<Diagnostic> RunLineArc(List<(int Line, string Text)> rows, Point2D start, Teller teller)
    {
        var (place, heading) = (start, 0.0);
        teller.GoTo(start);
        foreach (var (line, words) in rows)
        {
            var parts = words.Split('=');
            var (key, values) = (parts[0].Trim(), parts.Length == 2 ? Numbers(parts[1]) : null);
            switch (key, values)
            {
                case ("FirstTangent", [var degrees]): heading = degrees * Math.PI / 180.0; break;
                case ("DiscontinuityAngle", [_]): break;
                case ("Line", [var x, var y]):
                    var end = new Point2D(start.X + x, start.Y + y);
                    heading = Math.Atan2(end.Y - place.Y, end.X - place.X);
                    teller.LineTo(place = end);
                    break;
                case ("Arc", [var radius, var sweep]) when radius > 0.0 && sweep != 0.0:
                    (place, heading) = RunArc(place, heading, radius, sweep * Math.PI / 180.0, teller);
                    break;
                default: return [Unreadable(line, words)];
            }
        }

        return [];
    }

    /// <summary>In quarters of a turn at most, as the judges take arcs.</summary>
    private static (Point2D Place, double Heading) RunArc(Point2D place, double heading, double radius, double sweep, Teller teller)
    {
        var side = Math.Sign(sweep);
        var (x, y) = (place.X - (side * radius * Math.Sin(heading)), place.Y + (side * radius * Math.Cos(heading)));
        var from = heading - (side * Math.PI / 2.0);
        var parts = (int)Math.Ceiling(Math.Abs(sweep) / (Math.PI / 2.0));
        for (var i = 0; i < parts; i++) teller.ArcTo(new ArcSegment(new Point2D(x, y), radius, Angle.FromRadians(from + (sweep * i / parts)), Angle.FromRadians(sweep / parts)));
        return (new Point2D(x + (radius * Math.Cos(from + sweep)), y + (radius * Math.Sin(from + sweep))), heading + sweep);
    }

    /// <summary>From rest; each row adds its displacements in its time by the cubic fixed by both velocities, and the last ends at rest.</summary>
    private static IEnumerable<Diagnostic> RunPvt(List<(int Line, string Text)> rows, Point2D start, Teller teller)
    {
        var (x, y, vx, vy) = (start.X, start.Y, 0.0, 0.0);
        teller.GoTo(start);
        foreach (var (line, words) in rows)
        {
            if (Numbers(words) is not [var seconds, var dx, var endVx, var dy, var endVy] || !(seconds > 0.0)) return [Unreadable(line, words)];
            var leaving = (X: (6.0 * dx) - (seconds * ((4.0 * vx) + (2.0 * endVx))), Y: (6.0 * dy) - (seconds * ((4.0 * vy) + (2.0 * endVy))));
            var arriving = (X: (seconds * ((2.0 * vx) + (4.0 * endVx))) - (6.0 * dx), Y: (seconds * ((2.0 * vy) + (4.0 * endVy))) - (6.0 * dy));
            var chords = ChordsOf(leaving, arriving);
            for (var k = 1; k <= chords; k++)
            {
                var u = (double)k / chords;
                var (rise, leave, arrive) = (u * u * (3.0 - (2.0 * u)), u * (1.0 - u) * (1.0 - u), u * u * (u - 1.0));
                teller.LineTo(new Point2D(x + (dx * rise) + (seconds * ((vx * leave) + (endVx * arrive))), y + (dy * rise) + (seconds * ((vy * leave) + (endVy * arrive)))));
            }

            (x, y, vx, vy) = (x + dx, y + dy, endVx, endVy);
        }

        return vx == 0.0 && vy == 0.0 ? [] : [TrajectoryRules.LineUnreadable.At(default, Place(rows[^1].Line), Wording.Get("Xps.EndsInMotion"))];
    }

    /// <summary>Chords of equal steps of u that stay within the error: at most the largest second derivative by u, which a cubic has at an end, over 8 and the square of their number.</summary>
    private static int ChordsOf((double X, double Y) leaving, (double X, double Y) arriving)
    {
        var bend = Math.Max(double.Hypot(leaving.X, leaving.Y), double.Hypot(arriving.X, arriving.Y));
        return (int)Math.Clamp(Math.Ceiling(Math.Sqrt(bend / (8.0 * ChordError))), 1.0, MostChords);
    }

    private static double[]? Numbers(string words)
    {
        var parts = words.Split(',');
        var numbers = new double[parts.Length];
        for (var i = 0; i < parts.Length; i++)
        {
            if (!double.TryParse(parts[i], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i]) || !double.IsFinite(numbers[i])) return null;
        }

        return numbers;
    }

    private static Diagnostic Unreadable(int line, string words) => TrajectoryRules.LineUnreadable.At(default, Place(line), Wording.Get("Xps.LineSays", words.Trim()));

    private static string Place(int line) => line.ToString(CultureInfo.InvariantCulture);

    /// <summary>Tells the judges where the tool goes. The time is only an order.</summary>
    private sealed class Teller(IReadOnlyList<ITraceJudge> judges)
    {
        private Point2D _place;
        private double _seconds;

        /// <summary>With the tool off.</summary>
        public void GoTo(Point2D place)
        {
            _place = place;
            foreach (var judge in judges) judge.Add(new TraceSample(_seconds += 1.0, place.X, place.Y, Cutting: false));
        }

        public void LineTo(Point2D place)
        {
            if (place != _place) Tell(Segment.FromLine(_place, place));
        }

        public void ArcTo(ArcSegment arc) => Tell(Segment.FromArc(arc));

        private void Tell(in Segment path)
        {
            foreach (var judge in judges) judge.Add(new TraceSpan(_seconds, _seconds + 1.0, 2, path, Cutting: true));
            (_place, _seconds) = (path.End, _seconds + 1.0);
        }
    }
}

/// <summary>What a controller reads a trajectory file as.</summary>
public enum ControllerLanguage
{
    /// <summary>Points of the drawing.</summary>
    AbsoluteSpline,

    /// <summary>Points counted from where the machine stands.</summary>
    RelativeSpline,

    LineArc,

    Pvt,
}
