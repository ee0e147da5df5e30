using Engraver.Core.Geometry;
using Engraver.Core.Posts;
using Engraver.Core.Posts.Hpgl;
using Engraver.Core.Posts.HpglReading;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Posts;

/// <summary>HP-GL/2 as written and as read back (rs274-hpgl.md 3).</summary>
public class HpglTests
{
    [Fact]
    public void Places_are_whole_plotter_units_and_the_rounding_is_told()
    {
        var written = Written([[Line(0, 0, 10.01, -3), Line(10.01, -3, 10.03, -3)], [Line(5, 5, 5, 6)]]);

        Assert.Equal("IN;\nSP1;\nVS2;\nPU0,0;\nPD;\nPD400,-120;\nPD401,-120;\nPU;\nPU200,200;\nPD;\nPD200,240;\nPU;\nSP0;\n", written.Text);
        var finding = Assert.Single(written.Diagnostics);
        Assert.Equal(("PST0012", "0.025 0.01 10.01 -3"), (finding.Id, string.Join(' ', finding.Facts)));
    }

    [Fact]
    public void Finer_units_are_set_up_with_IP_and_SC_and_arcs_may_be_arcs()
    {
        var written = Written([[Arc(10, 0, 5, 180, -90)], [Arc(20, 0, 2, 0, 360)]], ("units-per-mm", "100"), ("arcs", "aa"), ("pen", "3"));

        Assert.Equal("IN;\nSP3;\nIP0,0,4000,4000;\nSC0,10000,0,10000;\nVS2;\nPU500,0;\nPD;\nAA1000,0,-90,3.5;\nPD1000,500;\nPU;\nPU2200,0;\nPD;\nAA2000,0,360,5.5;\nPU;\nSP0;\n", written.Text);
    }

    [Fact]
    public async Task An_arc_is_read_as_the_chords_that_a_plotter_draws()
    {
        var (found, told) = await RecordingJudge.ReadAsync(new HpglReader(), "in;sp1;vs1;pu400 0pd;aa 0,0,90,45;pr0,40;pu;");

        Assert.Equal("", found);
        Assert.Equal(3, told.Cuts.Count);
        Assert.True(told.Cuts[0].End.IsNear(new Point2D(5 * Math.Sqrt(2), 5 * Math.Sqrt(2)), 1e-9));
        Assert.True(told.Cuts[2].End.IsNear(new Point2D(0, 11), 1e-9));
        Assert.Equal(600.0, told.Feeds.Fastest!.Value, 1e-9);
    }

    [Theory]
    [InlineData("", "VER0001@0")]
    [InlineData("IN;SP1;", "VER0001@0")]
    [InlineData("SP1;PU0,0;", "PST0001@1")] // not initialised
    [InlineData("IN;\nPD1,1;", "PST0001@2")] // no pen
    [InlineData("IN;SP1;\nPU1;\n", "PST0001@2")]
    [InlineData("IN;SP1;\nPU1,2,3;\n", "PST0001@2")]
    [InlineData("IN;SP1;\nPU1,x;\n", "PST0001@2")]
    [InlineData("IN;SP1;\nPU1,1e3;\n", "PST0001@2")]
    [InlineData("IN;SP1;\nPU1,,2;\n", "PST0001@2")]
    [InlineData("IN;SP9;", "PST0001@1")]
    [InlineData("IN;SP1;\nLBtext;", "PST0001@2")]
    [InlineData("IN;SP1;\nPU9999999,0;", "PST0001@2")]
    [InlineData("IN;SP1;\nVS0;", "PST0001@2")]
    [InlineData("IN;SP1;PU0,0;\n7;", "PST0001@2")]
    [InlineData("IN;SP1;PU4,0;PD;\nAA0,0,0;", "PST0001@2")]
    [InlineData("IN;SP1;PU4,0;PD;\nAA0,0,90,0.1;", "PST0001@2")]
    [InlineData("IN;SP1;PU4,0;PD8,8;\n", "PST0001@2")] // the pen is left on the sheet
    [InlineData("IN;SP1;PU4,0;PD8,8;\nSP0;", "PST0001@2")]
    [InlineData("IN;SC0,1,0,1;", "PST0001@1")] // without IP its corners are the device's
    [InlineData("IN;SP1;PU1,1;IP0,0,40,40;\nSC0,1,0,1;", "PST0001@2")]
    public async Task What_is_no_program_or_might_draw_what_is_not_known_is_one_finding(string text, string findings) => Assert.Equal(findings, (await RecordingJudge.ReadAsync(new HpglReader(), text)).Findings);

    [Fact]
    public void A_place_beyond_the_numbers_of_the_form_is_an_error()
    {
        var written = Written([[Line(0, 0, 300_000, 0)]]);
        Assert.Equal(("PST0011", 0), (Assert.Single(written.Diagnostics).Id, written.Chunks.Count));
    }

    private static PostOutput Written(Segment[][] strokes, params (string Name, string Value)[] options) => new HpglPost().Write(UsualOptions.Post(
        new Toolpath(default, [.. strokes.Select((segments, index) => new ToolpathStroke(index, Closed: false, [.. segments.Select(segment => new StrokeMove(segment, 0))]))]), null, null, options.ToDictionary(option => option.Name, option => option.Value)));

    private static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));

    private static Segment Arc(double x, double y, double radius, double start, double sweep) => Segment.FromArc(new ArcSegment(new Point2D(x, y), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep)));
}
