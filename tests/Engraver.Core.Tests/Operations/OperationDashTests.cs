using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Operations;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;
using static Engraver.TestKit.LinetypeDrawing;

namespace Engraver.Core.Tests.Operations;

/// <summary>Patterns are twice as long as their elements ($LTSCALE): DASHED has dashes of 10 and gaps of 6.</summary>
public class OperationDashTests
{
    private const string Dashes = """{ "id": "a", "kind": "engrave", "select": "rest", "tool": 2, "depth": 1, "dashes": true }""";

    [Theory]
    [InlineData("HIDDEN", "BYLAYER", 1.0, 40.0, "0-9 15-25 31-40")]
    [InlineData("HIDDEN", "BYLAYER", 1.0, 16.0, "0-5 11-16")]
    [InlineData("HIDDEN", "BYLAYER", 1.0, 15.9, "0-15.9")]
    [InlineData("HIDDEN", "CONTINUOUS", 1.0, 40.0, "0-40")]
    [InlineData("0", "DASHED", 0.5, 20.0, "0-4.5 7.5-12.5 15.5-20")]
    [InlineData("0", "DOT", 1.0, 20.0, "0-4 5.95-6.05 8-12 13.95-14.05 16-20")]
    [InlineData("0", "GAS", 1.0, 30.0, "0-7 11-19 23-30")]
    public void A_line_begins_and_ends_with_half_a_dash_or_more(string layer, string linetype, double scale, double length, string expected)
    {
        var job = Job(Of(Line(layer, 0, 0, length, 0, (6, linetype), (48, scale))));

        Assert.Equal(expected, string.Join(' ', job.Path.Strokes.Select(stroke => stroke.Moves[0].Segment).OrderBy(segment => segment.Start.X + segment.End.X).Select(Text)));
        Assert.Empty(job.CheckOf(job.Path));
        Assert.Empty(job.CheckOfDashes(job.Shapes[0]));

        static string Text(Segment segment) => FormattableString.Invariant($"{Math.Round(Math.Min(segment.Start.X, segment.End.X), 6)}-{Math.Round(Math.Max(segment.Start.X, segment.End.X), 6)}");
    }

    [Fact]
    public void A_pattern_runs_through_a_polyline_that_says_so_and_otherwise_along_each_of_its_parts()
    {
        Assert.Equal([20.0], Lengths(Job(Of(Corner(0)))));
        Assert.Equal([7.0, 7.0], Lengths(Job(Of(Corner(128)))));
        Assert.Equal(20.0, Lengths(Job(Of(Corner(128, 2.5)))).Sum(), 6); // shorter than one pattern

        static (int, object)[] Corner(int flags, double scale = 1.0) => [(0, "LWPOLYLINE"), (8, "HIDDEN"), (48, scale), (90, 3), (70, flags), (10, 0.0), (20, 0.0), (10, 10.0), (20, 0.0), (10, 10.0), (20, 10.0)];
    }

    /// <summary>62.8 mm are four patterns of 16 mm, stretched.</summary>
    [Fact]
    public void A_closed_curve_has_a_whole_number_of_patterns()
    {
        var job = Job(Of((0, "CIRCLE"), (8, "HIDDEN"), (10, 0.0), (20, 0.0), (40, 10.0)));

        Assert.Equal(Enumerable.Repeat(Math.Round(20.0 * Math.PI * 10.0 / 64.0, 6), 4), Lengths(job));
        Assert.Empty(job.CheckOfDashes(job.Shapes[0]));
    }

    [Fact]
    public void Gaps_are_reported_with_what_the_tool_closes_and_what_is_not_cut()
    {
        var job = Job(Of([.. Line("HIDDEN", 0, 0, 40, 0, (48, 0.1)), .. Line("0", 0, 5, 40, 5, (6, "GAS"))]));

        Assert.Equal(["OPR0044", "OPR0045", "OPR0043"], job.Shapes[0].Findings.Select(finding => finding.Id));
        Assert.Equal(("2", "27"), (job.Shapes[0].Findings[0].Facts[1], job.Shapes[0].Findings[0].Facts[2])); // 25 gaps of 0.6 and 3 of 4
        Assert.Equal("OPR0046", Assert.Single(Job(Of(Line("0", 0, 0, 9, 0))).Shapes[0].Findings).Id);
        Assert.Equal("OPR0003", Assert.Single(Job(Of(Line("HIDDEN", 0, 0, 40, 0, (48, 1e-6)))).Shapes[0].Faults).Id);
    }

    /// <summary>Lines, arcs, circles, polylines with bulges, ellipses and splines with random patterns: the second formula agrees, and finds a dash that is
    /// missing, shortened, lengthened or turned away from its curve.</summary>
    [Fact]
    public void Dashes_agree_with_the_second_formula_and_faults_are_found()
    {
        var random = new Random(36);
        for (var round = 0; round < 60; round++)
        {
            var job = Job(Of(RandomCurve(random, round % 6)));
            var shape = job.Shapes[0];
            Assert.True(job.CheckOfDashes(shape).Count == 0 && job.CheckOf(job.Path).Count == 0, $"{round}");
            if (shape.Path.Count < 3) continue;
            foreach (var fault in (string[])["missing", "shorter", "longer", "aside"]) Assert.True(job.CheckOfDashes(shape with { Path = Damaged(shape.Path, fault, random) }).Count > 0, $"{round} {fault}");
        }
    }

    private static (int, object)[] RandomCurve(Random random, int kind)
    {
        (int, object)[] common = [(8, "0"), (6, ((string[])["DASHED", "DOT", "GAS"])[random.Next(3)]), (48, 0.2 + random.NextDouble())];
        double Number(double most) => Math.Round(random.NextDouble() * most, 3);
        return kind switch
        {
            0 => [(0, "LINE"), .. common, (10, 0.0), (20, 0.0), (11, 20.0 + Number(100)), (21, Number(100))],
            1 => [(0, "ARC"), .. common, (10, 5.0), (20, 5.0), (40, 10.0 + Number(50)), (50, Number(360)), (51, Number(360))],
            2 => [(0, "CIRCLE"), .. common, (10, 5.0), (20, 5.0), (40, 5.0 + Number(50))],
            3 or 4 => [(0, "LWPOLYLINE"), .. common, (90, 4), (70, (kind == 3 ? 128 : 0) | random.Next(2)), (10, 0.0), (20, 0.0), (42, Number(0.8)), (10, 30.0 + Number(30)), (20, 0.0), (10, 60.0), (20, 30.0 + Number(30)), (42, -Number(0.5)), (10, 0.0), (20, 40.0)],
            _ => [(0, "ELLIPSE"), .. common, (10, 0.0), (20, 0.0), (11, 20.0 + Number(30)), (21, Number(10)), (40, 0.3 + Number(0.6)), (41, 0.0), (42, 1.0 + Number(5.2))],
        };
    }

    private static EntityTable Damaged(EntityTable path, string fault, Random random)
    {
        var (damaged, row) = (new EntityTable(), fault == "missing" ? 0 : random.Next(path.Count));
        for (var i = 0; i < path.Count; i++)
        {
            var segment = path[i].ToSegment();
            if (i == row && fault == "missing") continue;
            if (i == row) segment = Segment.FromLine(segment.Start, fault switch { "shorter" => segment.Start, "longer" => segment.End + ((segment.End - segment.Start) * 0.5), _ => segment.End + new Vector2D(0.0, 0.5) });
            damaged.Append(EntitySlots.Of(segment, 0.0), path.EntityIndexOf(i), null);
        }

        return damaged;
    }

    private static OperationJob Job(DxfText text) => new(DxfReading.Of(text), Dashes);

    private static IEnumerable<double> Lengths(OperationJob job) => job.Path.Strokes.Select(stroke => Math.Round(stroke.Moves.Sum(move => move.Segment.Length), 6));
}
