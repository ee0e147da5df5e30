using System.Globalization;

namespace Engraver.Benchmarks.Motion;

/// <summary>Reads the toolpath from the program that the engraver posts as G-code: lines and arcs in millimetres, in the order in which they are cut.</summary>
internal static class GcodePath
{
    /// <summary>Elements shorter than this are rounding of the numbers in the program, mm.</summary>
    private const double Shortest = 2e-6;

    public static IReadOnlyList<IReadOnlyList<PathElement>> Read(string text)
    {
        var (strokes, stroke, at, mode) = (new List<IReadOnlyList<PathElement>>(), new List<PathElement>(), new Plane(0.0, 0.0), 0);
        foreach (var line in text.Split('\n'))
        {
            if (line.StartsWith('(') || line.StartsWith('%')) continue;
            var parts = line.Split(' ', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
            var words = parts.Select(word => (Letter: word[0], Value: Number(word[1..]))).ToList();
            foreach (var (letter, value) in words)
            {
                if (letter == 'G') mode = value is 0.0 or 1.0 or 2.0 or 3.0 ? (int)value : -1;
            }

            double? Of(char wanted) => words.Where(word => word.Letter == wanted).Select(word => (double?)word.Value).LastOrDefault();
            if (mode < 0 || (Of('X') ?? Of('Y')) is null) continue;
            var to = new Plane(Of('X') ?? at.X, Of('Y') ?? at.Y);
            if (mode == 0)
            {
                if (stroke.Count > 0) strokes.Add(stroke);
                stroke = [];
            }
            else if (mode == 1)
            {
                if ((to - at).Length > Shortest) stroke.Add(PathElement.Line(at, to));
            }
            else
            {
                stroke.Add(Arc(at, to, at + new Plane(Of('I') ?? 0.0, Of('J') ?? 0.0), isLeft: mode == 3));
            }

            at = to;
        }

        if (stroke.Count > 0) strokes.Add(stroke);
        return strokes;
    }

    private static PathElement Arc(Plane from, Plane to, Plane centre, bool isLeft)
    {
        var (first, last) = (from - centre, to - centre);
        var turn = first.TurnTo(last);
        if ((to - from).Length < Shortest) turn = 0.0;
        var sweep = isLeft ? (turn > 0.0 ? turn : turn + Math.Tau) : (turn < 0.0 ? turn : turn - Math.Tau);
        return PathElement.Arc(centre, (first.Length + last.Length) / 2.0, Math.Atan2(first.Y, first.X), sweep);
    }

    private static double Number(string word) => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) ? value : double.NaN;
}
