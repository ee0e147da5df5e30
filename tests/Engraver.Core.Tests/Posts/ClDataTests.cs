using System.Globalization;
using System.Text;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;
using Engraver.Core.Posts;
using Engraver.Core.Posts.ClDataReading;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Posts;

public class ClDataTests
{
    private const double Ulps = 1e-9;

    private static readonly Gen<double> Place = Gen.Choose(-50_000_000, 50_000_000).Select(n => n / 1e5);

    private static readonly Gen<Point2D> Point = Place.Two().Select(n => new Point2D(n.Item1, n.Item2));

    private static readonly Gen<Segment> AnySegment = Gen.OneOf(
        Point.Two().Select(ends => Segment.FromLine(ends.Item1, ends.Item2 + new Vector2D(0.125, 0.0))),
        Point.SelectMany(centre => Angles(0, 359_999_999).SelectMany(start => Angles(1, 359_999_999).SelectMany(sweep => Gen.Elements(-1.0, 1.0).Select(sense => Arc(centre.X, centre.Y, start, sense * sweep))))),
        Point.SelectMany(centre => Gen.Elements(0.0, 90.0, 180.0, 33.3).SelectMany(start => Gen.Elements(-360.0, 360.0).Select(sweep => Arc(centre.X, centre.Y, start, sweep)))));

    [Property]
    public Property Every_path_reads_back_with_its_order_directions_ends_and_lengths() =>
        Prop.ForAll(Arb.From(Gen.NonEmptyListOf(AnySegment)), segments =>
        {
            var found = CutParts(Read(ClDataText(segments))).ToList();
            Assert.Equal(segments.Count, found.Count);
            for (var i = 0; i < found.Count; i++) AssertSame(segments[i], found[i]);
        });

    /// <summary>Other programs draw an ARC from 30 to 390 degrees as a point. The start of the tool is in the extended data, which the reader of CL data
    /// uses.</summary>
    [Theory]
    [InlineData(0.0, 360.0)]
    [InlineData(180.0, 360.0)]
    [InlineData(30.0, 360.0)]
    [InlineData(0.0, -360.0)]
    [InlineData(180.0, -360.0)]
    [InlineData(90.0, -360.0)]
    public void A_whole_turn_is_a_circle_and_keeps_where_it_starts_and_which_way_round_it_goes(double start, double sweep)
    {
        var circle = Arc(3.0, 4.0, start, sweep);
        var text = ClDataText([circle]);
        var path = EntityOf(text, "CIRCLE").Path(out _)!.ToList();

        AssertSame(circle, CutParts(Read(text)).Single());
        Assert.DoesNotContain("\nARC\n", text, StringComparison.Ordinal);
        Assert.Equal(0.0, path[0].Start.DistanceTo(circle.Start) + path[^1].End.DistanceTo(circle.End), Ulps);
        Assert.Equal(0.0, path[0].End.DistanceTo(circle.Arc.PointAt(0.25)), Ulps);
    }

    [Fact]
    public void A_number_that_is_not_finite_names_its_entity_and_nothing_is_written()
    {
        var path = new Toolpath(default, [new ToolpathStroke(0, false, [new StrokeMove(Segment.FromLine(default, new Point2D(double.NaN, 1.0)), 7)])]);
        var written = new ClDataPost().Write(UsualOptions.Post(path, null, entity => new SourceRef(14, entity == 7 ? "2A" : null), new Dictionary<string, string>()));

        Assert.Empty(written.Chunks);
        Assert.Equal("PST0014", Assert.Single(written.Diagnostics).Id);
        Assert.Contains("2A", written.Diagnostics[0].Message, StringComparison.Ordinal);
    }

    private static ClDataEntity EntityOf(string text, string type)
    {
        var lines = text.Split('\n');
        var at = Array.IndexOf(lines, type) + 1;
        var entity = new ClDataEntity(type, at);
        for (; lines[at] != "0"; at += 2) entity.Add(int.Parse(lines[at], CultureInfo.InvariantCulture), lines[at + 1]);
        return entity;
    }

    [Fact]
    public void Rapids_stand_between_the_strokes_on_a_layer_that_is_not_cut()
    {
        var drawing = Read(ClDataText([Arc(0.0, 0.0, 0.0, 90.0), Segment.FromLine(new Point2D(7.0, 7.0), new Point2D(8.0, 7.0))]));

        Assert.Equal(["RAPID", "CUT_OPEN", "RAPID", "CUT_OPEN"], Enumerable.Range(0, drawing.Entities.Count).Select(i => drawing.Layers[drawing.Entities[i].Layer].Name));
        Assert.False(drawing.Layers.Single(layer => layer.Name == ClData.RapidLayer).CutByDefault);
        Assert.True(drawing.Layers.Single(layer => layer.Name == ClData.OpenLayer).CutByDefault);
        Assert.Empty(drawing.Diagnostics);
    }

    [Fact]
    public void The_drawing_says_that_it_is_in_millimetres_and_carries_sequence_and_stroke_numbers()
    {
        var text = ClDataText([Arc(0.0, 0.0, 0.0, 90.0), Segment.FromLine(new Point2D(7.0, 7.0), new Point2D(8.0, 7.0))]);

        Assert.Equal(("mm", "INSUNITS", "AC1015"), (Read(text).Unit.Name, Read(text).Unit.Source, Read(text).DxfVersion));
        Assert.Contains("1001\nCNCENGRAVER\n1000\nrapid\n1071\n0\n1071\n1\n", text, StringComparison.Ordinal);
        Assert.Contains("1001\nCNCENGRAVER\n1000\ncut\n1071\n2\n1071\n2\n", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Handles_are_unique_and_below_the_seed()
    {
        var lines = ClDataText([.. Enumerable.Range(0, 300).Select(i => Segment.FromLine(new Point2D(i, 0.0), new Point2D(i, 1.0)))]).Split('\n');
        var pairs = Enumerable.Range(0, lines.Length / 2).Select(i => (Code: lines[2 * i], Value: lines[(2 * i) + 1])).ToList();
        var seed = pairs.FindIndex(pair => pair.Value == "$HANDSEED");
        var handles = pairs.Skip(seed + 2).Where(pair => pair.Code is "5" or "105").Select(pair => int.Parse(pair.Value, NumberStyles.HexNumber, CultureInfo.InvariantCulture)).ToList();

        Assert.Equal(handles.Count, handles.Distinct().Count());
        Assert.All(handles, handle => Assert.InRange(handle, 1, int.Parse(pairs[seed + 1].Value, NumberStyles.HexNumber, CultureInfo.InvariantCulture) - 1));
    }

    [Fact]
    public void An_arc_too_small_for_an_angle_is_written_as_a_line_and_not_lost()
    {
        var speck = Arc(0.0, 0.0, 10.0, 1e-10);

        Assert.Equal(SegmentKind.Line, CutParts(Read(ClDataText([speck]))).Single().Kind);
    }

    [Fact]
    public void An_empty_path_is_an_empty_drawing()
    {
        var drawing = Read(ClDataText([]));

        Assert.Equal(0, drawing.Entities.Count);
        Assert.False(drawing.HasErrors);
    }

    private static Gen<double> Angles(int least, int most) => Gen.Choose(least, most).Select(n => n / 1e6);

    private static Segment Arc(double x, double y, double start, double sweep) =>
        Segment.FromArc(new ArcSegment(new Point2D(x, y), 1.0 + Math.Abs(x), Angle.FromDegrees(start), Angle.FromDegrees(sweep)));

    /// <summary>Each segment is a separate stroke.</summary>
    private static string ClDataText(IReadOnlyList<Segment> segments)
    {
        using var text = new StringWriter();
        ClData.Write(new Toolpath(new Point2D(-1.0, -1.0), [.. segments.Select((segment, i) => new ToolpathStroke(i, false, [new StrokeMove(segment, i)]))]), null, text);
        return text.ToString();
    }

    private static Drawing Read(string text) => DxfReader.Read(Encoding.ASCII.GetBytes(text), "cl.dxf", new DxfReadOptions(), CancellationToken.None);

    private static IEnumerable<Segment> CutParts(Drawing drawing) => Enumerable.Range(0, drawing.Parts.Count)
        .Where(i => drawing.Layers[drawing.Entities[drawing.Parts[i].Entity].Layer].Name != ClData.RapidLayer)
        .Select(i => drawing.Parts[i].InPlan());

    private static void AssertSame(Segment expected, Segment found)
    {
        Assert.Equal(expected.Kind, found.Kind);
        if (expected.Kind != SegmentKind.Circle) Assert.Equal(0.0, expected.Start.DistanceTo(found.Start) + expected.End.DistanceTo(found.End), Ulps);
        Assert.Equal(expected.Length, found.Length, Ulps);
        if (expected.Kind != SegmentKind.Line) Assert.Equal(Math.Sign(expected.Arc.Sweep.Degrees), Math.Sign(found.Arc.Sweep.Degrees));
        var (box, other) = (expected.Bounds, found.Bounds);
        Assert.Equal(0.0, Math.Abs(box.MinX - other.MinX) + Math.Abs(box.MaxX - other.MaxX) + Math.Abs(box.MinY - other.MinY) + Math.Abs(box.MaxY - other.MaxY), 4.0 * Ulps);
    }
}
