using Engraver.Core.Operations;
using Engraver.Core.Tests.Dxf;
using Engraver.Core.Toolpaths;
using static Engraver.TestKit.LineweightDrawing;

namespace Engraver.Core.Tests.Operations;

public class OperationWidthTests
{
    private const string ByWidth = """{"id": "v", "name": "Marks", "kind": "engrave", "select": "rest", "tool": 3, "startDepth": 1, "depth": "lineWidth" """;

    /// <summary>With an angle of 60 degrees and a tip of 0.1 mm, a groove of a width is deeper than its tip by (width - 0.1) / (2 tan 30).</summary>
    [Fact]
    public void Each_width_is_an_operation_at_the_depth_at_which_the_groove_is_as_wide()
    {
        var job = new OperationJob(DxfReading.Of(Of([.. Line("THICK", 0), .. Line("0", 1), .. Line("THICK", 2, (370, 25)), .. Polyline((43, 0.7), (10, 0.0), (20, 3.0), (10, 9.0), (20, 3.0))])), ByWidth + "}");

        Assert.Equal(["v@0.25 Marks 0.25 mm 1.129904", "v@0.5 Marks 0.5 mm 1.34641", "v@0.7 Marks 0.7 mm 1.519615"], job.Shapes.Select(shape => FormattableString.Invariant($"{shape.Operation.Id} {shape.Operation.Title} {shape.Operation.Depth:0.######}")));
        Assert.Equal([2, 1, 1], job.Shapes.Select(shape => shape.Path.Count));
        Assert.Equal([1.129904, 1.129904, 1.34641, 1.519615], job.Path.Strokes.Select(stroke => Math.Round(-stroke.Moves[0].StartZ, 6)));
        Assert.Empty(job.Assignment.Faults);
        Assert.Empty(job.CheckOf(job.Path));
        Assert.Empty(job.CheckOfWidths(job.Path));
        Assert.Equal("lineWidth", (string?)System.Text.Json.Nodes.JsonNode.Parse(job.Plan.ToString())!["operations"]![0]!["depth"]);
        Assert.Equal(job.Plan, OperationFile.Parse(job.Plan.ToString()));
    }

    [Fact]
    public void A_cut_at_another_depth_and_a_width_that_is_not_cut_are_found()
    {
        var job = new OperationJob(DxfReading.Of(Of([.. Line("THICK", 0), .. Line("0", 1)])), ByWidth + "}");
        var lower = job.Path with { Strokes = [job.Path.Strokes[0], Moved(job.Path.Strokes[1], -0.0001)] };

        Assert.Equal("OPR0018", Assert.Single(job.CheckOfWidths(lower)));
        Assert.Equal("OPR0018", Assert.Single(job.CheckOfWidths(job.Path, job.Assignment with { Parts = [job.Assignment.Parts[0], job.Assignment.Parts[1] with { Table = job.Assignment.Parts[0].Table }] })));
    }

    [Theory]
    [InlineData(0, "OPR0060")]
    [InlineData(9, "OPR0060")] // not wider than the tip
    [InlineData(211, "OPR0060")] // wider than the cutter
    [InlineData(100, "OPR0013")] // deeper than its edges
    public void Widths_that_the_tool_cannot_cut_are_refused(int weight, string expected)
    {
        Assert.Equal(expected, Assert.Single(new OperationJob(DxfReading.Of(Of(Line("0", 0, (370, weight)))), ByWidth + "}").Assignment.Faults).Id);
    }

    [Fact]
    public void A_width_that_varies_is_refused_and_passes_divide_each_depth()
    {
        Assert.Equal("OPR0061", Assert.Single(new OperationJob(DxfReading.Of(Of(Polyline((10, 0.0), (20, 3.0), (40, 0.2), (41, 0.4), (10, 9.0), (20, 3.0)))), ByWidth + "}").Assignment.Faults).Id);
        Assert.Equal("OPR0003", Assert.Single(new OperationJob(DxfReading.Of(Of(Line("0", 0))), ByWidth + """, "finish": 0.2}""").Assignment.Faults).Id);
        Assert.Equal("OPR0003", Assert.Single(new OperationJob(DxfReading.Of(Of(Line("0", 0))), ByWidth + """, "depthPerPass": 0.0001}""").Assignment.Faults).Id);

        var job = new OperationJob(DxfReading.Of(Of([.. Line("0", 0), .. Line("THICK", 1)])), ByWidth + """, "depthPerPass": 0.2, "finish": 0.05, "repeats": 2}""");

        Assert.Equal([1.079904, 1.129904, 1.129904, 1.148205, 1.29641, 1.34641, 1.34641], job.Path.Strokes.Select(stroke => Math.Round(-stroke.Moves[0].StartZ, 6)));
        Assert.Empty(job.CheckOf(job.Path).Concat(job.CheckOfWidths(job.Path)));
        Assert.Equal(["OPR0009"], new OperationJob(DxfReading.Of(Of(Line("0", 0))), """{"id": "v", "kind": "engrave", "select": {"layers": ["THICK"]}, "tool": 3, "depth": "lineWidth"}""").Assignment.Findings.Select(finding => finding.Id).Except(["OPR0008"]));
    }

    private static ToolpathStroke Moved(ToolpathStroke stroke, double by) => stroke with { Moves = [.. stroke.Moves.Select(move => move with { StartZ = move.StartZ + by, EndZ = move.EndZ + by })] };
}
