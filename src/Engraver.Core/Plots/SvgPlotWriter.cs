using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Languages;
using static Engraver.Core.Plots.SvgPath;

namespace Engraver.Core.Plots;

/// <summary>A plot as one self-contained SVG file: dark like a CAD canvas, y up, legend and size below. The same model gives the same bytes.</summary>
public static class SvgPlotWriter
{
    private const int MaxLabels = 300;
    private const double ArrowLength = 11.0;
    private const double FontSize = 12.0;

    private const string Style = """
        <style>
          .field{fill:#1b1f24} .caption{fill:#242a31} text{font-family:'DejaVu Sans',Verdana,sans-serif;fill:#c9d1d9}
          .cut{fill:none;stroke-linejoin:round;stroke-linecap:round} .closed{stroke:#4fc3f7} .open{stroke:#ffb74d}
          .rapid{fill:none;stroke:#ef6f6c;stroke-opacity:.8;stroke-dasharray:6 5} .start{fill:none;stroke:#7ee787;stroke-width:2}
          .number{fill:#f0f3f6;stroke:#1b1f24;stroke-width:3;paint-order:stroke} .arrow.closed{fill:#4fc3f7;stroke:none} .arrow.open{fill:#ffb74d;stroke:none}
        </style>
        """;

    /// <summary>Writes the picture; LF line ends, numbers invariant.</summary>
    public static void Write(PlotModel plot, TextWriter output) => Write(plot, new PlotFrame(plot.VisibleBounds), thinned: null, output);

    /// <summary>Writes the picture for a page of limited size: when its lines need more characters, at the finest resolution at which they fit.</summary>
    /// <param name="most">Maximum number of characters of its lines.</param>
    /// <returns>The resolution in millimetres of the drawing; null for a complete picture.</returns>
    public static double? WriteWithin(PlotModel plot, int most, TextWriter output)
    {
        ArgumentNullException.ThrowIfNull(plot);
        var frame = new PlotFrame(plot.VisibleBounds);
        var thinned = ThinnedPlot.WholeLength(plot) > most ? ThinnedPlot.Of(plot, frame, most, Colour) : null;
        Write(plot, frame, thinned, output);
        return thinned?.Cell / frame.Scale;
    }

    private static void Write(PlotModel plot, PlotFrame frame, ThinnedPlot? thinned, TextWriter output)
    {
        var size = $"{Number(frame.FieldWidth)} {Number(frame.Height)}";
        Line(output, $"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {size}\" width=\"{Number(frame.FieldWidth)}\" height=\"{Number(frame.Height)}\">");
        Line(output, Style.ReplaceLineEndings("\n"));
        if (plot.Heat is not null) Line(output, HeatStyle());
        if (plot.Marks.Count > 0) Line(output, "<style>.point{fill:#f0f3f6} .corner{fill:none;stroke:#d2a8ff;stroke-width:1.5}</style>");
        Line(output, $"<rect class=\"field\" width=\"100%\" height=\"100%\"/>");
        if (thinned is not null) WritePaths(plot, thinned.Rapids, thinned.Strokes, output);
        else WritePaths(plot, plot.Rapids.Count > 0 ? Format([.. plot.Rapids.Select(Segment.FromLine)], frame) : "", plot.Strokes.Select(stroke => (Colour(stroke), Format(stroke.Segments, frame))), output);
        WritePoints(plot, frame, output);
        WriteMarks(plot, frame, output);
        WriteCaption(plot, frame, output);
        Line(output, "</svg>");
    }

    private static void WritePaths(PlotModel plot, string rapids, IEnumerable<(string Colour, string Path)> strokes, TextWriter output)
    {
        if (rapids.Length > 0) Line(output, $"<path class=\"rapid\" d=\"{rapids}\"/>");
        Line(output, $"<g stroke-width=\"{StrokeWidth(plot)}\">");
        foreach (var (colour, path) in strokes) Line(output, $"<path class=\"cut {colour}\" d=\"{path}\"/>");
        Line(output, "</g>");
    }

    private static string StrokeWidth(PlotModel plot) => Number(Math.Clamp(2.2 - (plot.Strokes.Count / 1000.0), 0.8, 2.0));

    private static void WriteMarks(PlotModel plot, PlotFrame frame, TextWriter output)
    {
        if (plot.ToolStart is { } start) WriteToolStart(frame.Place(start), output);
        if (!plot.Strokes.Any(stroke => stroke.Number is not null)) return;
        var labels = new LabelField(FontSize / 2.0);
        var every = ((plot.Strokes.Count - 1) / MaxLabels) + 1;
        for (var i = 0; i < plot.Strokes.Count; i += every) WriteNumber(plot.Strokes[i], frame, labels, output);
        for (var i = 0; i < plot.Strokes.Count; i += every) WriteArrow(plot.Strokes[i], frame, labels, output);
    }

    /// <summary>A dot for each point of a trajectory, a diamond around each corner.</summary>
    private static void WritePoints(PlotModel plot, PlotFrame frame, TextWriter output)
    {
        foreach (var mark in plot.Marks)
        {
            var place = frame.Place(mark.Place);
            if (mark.IsCorner) Line(output, $"<path class=\"corner\" d=\"M{Number(place.X - 6.0)},{Number(place.Y)}L{Number(place.X)},{Number(place.Y - 6.0)}L{Number(place.X + 6.0)},{Number(place.Y)}L{Number(place.X)},{Number(place.Y + 6.0)}Z\"/>");
            else Line(output, $"<circle class=\"point\" cx=\"{Number(place.X)}\" cy=\"{Number(place.Y)}\" r=\"2.2\"/>");
        }
    }

    private static void WriteToolStart(Point2D place, TextWriter output) =>
        Line(output, $"<path class=\"start\" d=\"M{Number(place.X - 9.0)},{Number(place.Y)}h18M{Number(place.X)},{Number(place.Y - 9.0)}v18\"/><circle class=\"start\" cx=\"{Number(place.X)}\" cy=\"{Number(place.Y)}\" r=\"5\"/>");

    /// <summary>Draws a dot where cutting starts and its number next to it (four positions are tried; when all are taken, the number is left out).</summary>
    private static void WriteNumber(PlotStroke stroke, PlotFrame frame, LabelField labels, TextWriter output)
    {
        var text = stroke.Number?.ToString(CultureInfo.InvariantCulture) ?? string.Empty;
        var start = frame.Place(stroke.Segments[0].Start);
        var width = text.Length * FontSize * 0.64;
        foreach (var offset in new Vector2D[] { new(5.0, -4.0), new(-5.0 - width, -4.0), new(5.0, FontSize + 3.0), new(-5.0 - width, FontSize + 3.0) })
        {
            var place = start + offset;
            if (!labels.TryReserve(place - new Vector2D(0.0, FontSize * 0.8), width, FontSize * 0.8)) continue;
            Line(output, $"<circle class=\"arrow {Colour(stroke)}\" cx=\"{Number(start.X)}\" cy=\"{Number(start.Y)}\" r=\"2.6\"/><text class=\"number\" font-size=\"{Number(FontSize)}\" x=\"{Number(place.X)}\" y=\"{Number(place.Y)}\">{text}</text>");
            return;
        }
    }

    /// <summary>An arrow head on the middle of the stroke's middle segment; short strokes go without.</summary>
    private static void WriteArrow(PlotStroke stroke, PlotFrame frame, LabelField labels, TextWriter output)
    {
        if (stroke.Length * frame.Scale < 3.0 * ArrowLength) return;
        var segment = stroke.Segments.Count > 1 ? stroke.Segments.MaxBy(part => part.Length) : stroke.Segments[0];
        var travel = PlotFrame.Turn(segment.TangentAt(0.5));
        var side = new Vector2D(-travel.Y, travel.X) * (ArrowLength * 0.38);
        var tip = frame.Place(segment.PointAt(0.5)) + (travel * (ArrowLength / 2.0));
        var back = tip - (travel * ArrowLength);
        if (!labels.TryReserve(tip - new Vector2D(ArrowLength / 2.0, ArrowLength / 2.0), ArrowLength, ArrowLength)) return;
        Line(output, $"<path class=\"arrow {Colour(stroke)}\" d=\"M{Pair(tip)}L{Pair(back + side)}L{Pair(back - side)}Z\"/>");
    }

    private static void WriteCaption(PlotModel plot, PlotFrame frame, TextWriter output)
    {
        var (top, drawn) = (frame.FieldHeight, plot.DrawnBounds);
        var closed = plot.Strokes.Count(stroke => stroke.Closed);
        Line(output, $"<rect class=\"caption\" y=\"{Number(top)}\" width=\"100%\" height=\"{Number(PlotFrame.CaptionHeight)}\"/>");
        Line(output, $"<text x=\"16\" y=\"{Number(top + 21.0)}\" font-size=\"14\">{MarkupText.Escaped(Wording.Get("Plot.Size", plot.Title, NumberText.Rounded(drawn.Width, 2), NumberText.Rounded(drawn.Height, 2)))}</text>");
        var caption = plot.Heat?.Caption ?? (plot.ToolStart is null
            ? Wording.Get("Plot.Strokes", plot.Strokes.Count, NumberText.Rounded(plot.CutLength, 2))
            : Wording.Get("Plot.StrokesAndTravel", plot.Strokes.Count, NumberText.Rounded(plot.CutLength, 2), NumberText.Rounded(plot.Travel, 2)));
        Line(output, $"<text x=\"16\" y=\"{Number(top + 42.0)}\" font-size=\"12\">{MarkupText.Escaped(caption)}</text>");
        var entries = new List<(string Class, string Text)> { ("cut closed", Wording.Get("Plot.Closed", closed)), ("cut open", Wording.Get("Plot.Open", plot.Strokes.Count - closed)) };
        if (plot.Heat is { } heat) entries = [($"cut {HeatClass(0)}", heat.Min), ($"cut {HeatClass(RunPlot.Steps - 1)}", heat.Max)];
        if (plot.ToolStart is not null) entries.AddRange([("rapid", Wording.Get("Plot.Rapid")), ("start", Wording.Get("Plot.Start"))]);
        for (var i = 0; i < entries.Count; i++) WriteLegend(entries[i].Class, entries[i].Text, frame.FieldWidth - (122.0 * (entries.Count - i)), top + 42.0, output);
    }

    private static void WriteLegend(string css, string text, double x, double y, TextWriter output) =>
        Line(output, $"<path class=\"{css}\" stroke-width=\"2\" d=\"M{Number(x)},{Number(y - 4.0)}h24\"/><text x=\"{Number(x + 30.0)}\" y=\"{Number(y)}\" font-size=\"12\">{MarkupText.Escaped(text)}</text>");

    private static string Colour(PlotStroke stroke) => stroke.Heat is { } heat ? HeatClass(heat) : stroke.Closed ? "closed" : "open";

    private static string HeatClass(int step) => step < 0 ? "base" : string.Create(CultureInfo.InvariantCulture, $"heat{step}");

    /// <summary>Colours from green through yellow to red, and grey for the drawing beneath.</summary>
    private static string HeatStyle() =>
        $"<style>.base{{stroke:#4a5460}}{string.Concat(Enumerable.Range(0, RunPlot.Steps).Select(step => $".{HeatClass(step)}{{stroke:{HeatColour((double)step / (RunPlot.Steps - 1))}}}"))}</style>";

    private static string HeatColour(double part) => string.Create(CultureInfo.InvariantCulture, $"#{(int)Math.Min(255.0, 510.0 * part):x2}{(int)Math.Min(224.0, 448.0 * (1.0 - part)):x2}50");

    private static void Line(TextWriter output, string text)
    {
        output.Write(text);
        output.Write('\n');
    }
}
