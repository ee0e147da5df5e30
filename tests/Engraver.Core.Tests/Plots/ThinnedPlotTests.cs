using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Geometry;
using Engraver.Core.Plots;

namespace Engraver.Core.Tests.Plots;

/// <summary>A picture of very many lines on a page: small, and still showing all of them.</summary>
public partial class ThinnedPlotTests
{
    private static readonly PlotStroke s_frame = new([Segment.FromLine(new(0.0, 0.0), new(1200.0, 0.0)), Segment.FromLine(new(1200.0, 0.0), new(1200.0, 1200.0))], false, 1);

    [Fact]
    public void What_fits_is_drawn_whole()
    {
        var plot = Picture(lines: 40, seed: 1);
        var (whole, within) = (new StringWriter(), new StringWriter());
        SvgPlotWriter.Write(plot, whole);

        Assert.Null(SvgPlotWriter.WriteWithin(plot, 10_000, within));
        Assert.Equal(whole.ToString(), within.ToString());
    }

    /// <summary>A picture of 1200 units for 1200 mm: one unit is one millimetre.</summary>
    [Theory]
    [InlineData(900_000, 0.5)]
    [InlineData(400_000, 4.0)]
    public void Every_line_has_something_drawn_within_the_resolution_and_nothing_else_is_drawn(int most, double expected)
    {
        var plot = Picture(lines: 20_000, seed: 2);
        var (text, resolution) = Written(plot, most);
        var drawn = Lines(text, "cut open");
        var field = new NearField(drawn, 1288.0);
        var lines = plot.Strokes.SelectMany(stroke => stroke.Segments).ToList();
        var source = new NearField([.. lines.Select(line => (Place(line.Start), Place(line.End)))], 1288.0);

        Assert.Equal(expected, resolution);
        Assert.InRange(text.Length, most / 4, most + 60_000); // numbers, arrows and the caption are added to the lines
        Assert.All(lines, line => Assert.True(new[] { line.Start, line.PointAt(0.5), line.End }.All(place => field.Distance(Place(place)) <= (1.5 * Math.Sqrt(2.0) * expected) + 0.1), $"{line.Start} to {line.End}"));
        Assert.All(drawn, line => Assert.True(source.Distance(line.From) <= (0.5 * expected) + 0.1 && source.Distance(line.To) <= (0.5 * expected) + 0.1, $"{line.From} to {line.To}"));
    }

    [Fact]
    public void What_is_smaller_than_the_resolution_is_a_dot_and_does_not_vanish()
    {
        var circles = Enumerable.Range(0, 3000).Select(i => new PlotStroke([Segment.FromArc(new ArcSegment(new Point2D(3.0 + (20.0 * (i % 60)), 3.0 + (20.0 * (i / 60))), 0.01, Angle.FromDegrees(0.0), Angle.FromDegrees(360.0)))], true, i + 2));
        var (text, _) = Written(new PlotModel("dots", [s_frame, .. circles], [], null), 120_000);

        Assert.Equal(3000, Lines(text, "cut closed").Select(line => line.From).Distinct().Count());
    }

    [Fact]
    public void The_largest_of_a_measure_lies_on_top()
    {
        var strokes = Picture(lines: 5000, seed: 3).Strokes.Select((stroke, i) => stroke with { Heat = (i % 17) - 1, Number = null });
        var (text, _) = Written(new PlotModel("run", [.. strokes], [], null) { Heat = new PlotHeat("deviation", "0", "1") }, 50_000);

        Assert.Equal(["base", .. Enumerable.Range(0, 16).Select(step => $"heat{step}")], HeatClass().Matches(text).Select(match => match.Groups[1].Value));
    }

    private static (string Text, double? Resolution) Written(PlotModel plot, int most)
    {
        var output = new StringWriter();
        var resolution = SvgPlotWriter.WriteWithin(plot, most, output);
        return (output.ToString(), resolution);
    }

    /// <summary>Short lines at random, many of them overlapping.</summary>
    private static PlotModel Picture(int lines, int seed)
    {
        var random = new Random(seed);
        Point2D At() => new(1200.0 * random.NextDouble() * random.NextDouble(), 1200.0 * random.NextDouble());
        PlotStroke Line(int number)
        {
            var start = At();
            return new PlotStroke([Segment.FromLine(start, start + Vector2D.FromPolar(12.0 * random.NextDouble(), Angle.FromDegrees(360.0 * random.NextDouble())))], false, number);
        }

        var strokes = Enumerable.Range(2, lines).Select(Line).Where(stroke => stroke.Segments[0].Bounds is { MinX: >= 0.0, MinY: >= 0.0, MaxX: <= 1200.0, MaxY: <= 1200.0 });
        return new PlotModel("many", [s_frame, .. strokes], [], null);
    }

    private static Point2D Place(Point2D drawn) => new(44.0 + drawn.X, 44.0 + 1200.0 - drawn.Y);

    private static List<(Point2D From, Point2D To)> Lines(string text, string css)
    {
        var (lines, pen) = (new List<(Point2D, Point2D)>(), default(Point2D));
        foreach (Match path in Regex.Matches(text, $"<path class=\"{css}\" d=\"([^\"]*)\"/>"))
        {
            foreach (Match move in Move().Matches(path.Groups[1].Value))
            {
                var to = new Point2D(double.Parse(move.Groups[2].Value, CultureInfo.InvariantCulture), double.Parse(move.Groups[3].Value, CultureInfo.InvariantCulture));
                if (move.Groups[1].Value == "L") lines.Add((pen, to));
                pen = to;
            }
        }

        return lines;
    }

    [GeneratedRegex("([ML])([-0-9.]+),([-0-9.]+)")]
    private static partial Regex Move();

    [GeneratedRegex("<path class=\"cut (base|heat[0-9]+)\" d=")]
    private static partial Regex HeatClass();

    /// <summary>Distance to the nearest of many short lines.</summary>
    private sealed class NearField
    {
        private const double Tile = 16.0;
        private readonly ILookup<(int, int), (Point2D From, Point2D To)> _tiles;

        public NearField(List<(Point2D From, Point2D To)> lines, double size) =>
            _tiles = lines.SelectMany(line => Tiles(Bounds2D.FromCorners(line.From, line.To).Grown(8.0), size), (line, tile) => (line, tile)).ToLookup(one => one.tile, one => one.line);

        public double Distance(Point2D place) => _tiles[((int)(place.X / Tile), (int)(place.Y / Tile))].Select(line => Distance(line, place)).DefaultIfEmpty(double.PositiveInfinity).Min();

        private static double Distance((Point2D From, Point2D To) line, Point2D place)
        {
            var along = line.To - line.From;
            var part = along.LengthSquared > 0.0 ? Math.Clamp((place - line.From).Dot(along) / along.LengthSquared, 0.0, 1.0) : 0.0;
            return place.DistanceTo(line.From + (along * part));
        }

        private static IEnumerable<(int, int)> Tiles(Bounds2D box, double size)
        {
            for (var x = (int)Math.Max(0.0, box.MinX / Tile); x <= (int)(Math.Min(size, box.MaxX) / Tile); x++)
            {
                for (var y = (int)Math.Max(0.0, box.MinY / Tile); y <= (int)(Math.Min(size, box.MaxY) / Tile); y++) yield return (x, y);
            }
        }
    }
}
