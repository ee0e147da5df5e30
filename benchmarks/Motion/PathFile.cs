using System.Globalization;
using System.Text.Json;

namespace Engraver.Benchmarks.Motion;

/// <summary>Strokes and the bounds of the motion along them, as JSON: a line is [x1, y1, x2, y2], an arc [cx, cy, r, start degrees, sweep degrees].</summary>
internal sealed record PathFile(MotionBounds Bounds, IReadOnlyList<IReadOnlyList<PathElement>> Strokes)
{
    public static PathFile Read(string name)
    {
        using var document = JsonDocument.Parse(File.ReadAllBytes(name));
        var root = document.RootElement;
        double Value(string key) => root.GetProperty(key).GetDouble();
        var bounds = new MotionBounds(Value("feed"), Value("acceleration"), Value("tolerance"), Value("countsPerMm"));
        var strokes = root.GetProperty("strokes").EnumerateArray();
        return new PathFile(bounds, [.. strokes.Select(stroke => (IReadOnlyList<PathElement>)[.. stroke.EnumerateArray().Select(Element)])]);
    }

    public void Write(string name)
    {
        using var file = File.CreateText(name);
        file.Write(string.Create(CultureInfo.InvariantCulture, $"{{\"feed\": {Bounds.Feed}, \"acceleration\": {Bounds.Acceleration}, "));
        file.Write(string.Create(CultureInfo.InvariantCulture, $"\"tolerance\": {Bounds.Tolerance}, \"countsPerMm\": {Bounds.CountsPerMm}, "));
        file.WriteLine("\"strokes\": [");
        for (var i = 0; i < Strokes.Count; i++) file.WriteLine($"[{string.Join(",\n", Strokes[i].Select(Text))}]{(i + 1 < Strokes.Count ? "," : "]}")}");
    }

    private static PathElement Element(JsonElement numbers)
    {
        double[] n = [.. numbers.EnumerateArray().Select(number => number.GetDouble())];
        return n.Length == 4
            ? PathElement.Line(new Plane(n[0], n[1]), new Plane(n[2], n[3]))
            : PathElement.Arc(new Plane(n[0], n[1]), n[2], double.DegreesToRadians(n[3]), double.DegreesToRadians(n[4]));
    }

    private static string Text(PathElement element)
    {
        double[] numbers = element.IsLine
            ? [element.From.X, element.From.Y, element.To.X, element.To.Y]
            : [element.Centre.X, element.Centre.Y, element.Radius, double.RadiansToDegrees(element.Start), double.RadiansToDegrees(element.Sweep)];
        return $"[{string.Join(", ", numbers.Select(number => number.ToString(CultureInfo.InvariantCulture)))}]";
    }
}
