using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Posts.Gcode;
using Engraver.Core.Posts.GcodeReading;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Posts;

/// <summary>The exact output of the G-code post, and the limits of the controllers that read it (rs274-hpgl.md).</summary>
public class GcodePostTests
{
    private static readonly Segment[] s_slot = [Line(0, 0, 20, 0), Arc(20, 5, 5, 270, 180), Line(20, 10, 0, 10)];

    [Fact]
    public void LinuxCNC_is_given_marks_six_decimals_and_the_tool_on_the_spindles_switch() => Assert.Equal(
        """
        %
        (CncEngraver, linuxcnc, mm)
        G21 G17 G90 G91.1
        G94 G40 G49 G80
        G54 G61
        M5
        G0 X0 Y0
        M3 S1000
        G4 P0.1
        G1 X20 Y0 F1200
        G3 X20 Y10 I0 J5
        G1 X0 Y10
        M5
        G4 P0.1
        G0 X43.333333 Y0
        M3 S1000
        G4 P0.1
        G2 X43.333333 Y0 I-3.333333 J0
        M5
        G4 P0.1
        M2
        %

        """, Written([s_slot, [Arc(40, 0, 10.0 / 3.0, 0, -360)]]).Text);

    [Fact]
    public void Grbl_is_given_four_decimals_and_no_marks_and_every_choice_is_obeyed()
    {
        var text = Written([[Arc(40, 0, 10.0 / 3.0, 0, -360)]], new MachineProfile { ToolSettleSeconds = 0.0 }, ("dialect", "grbl"), ("work-offset", "G57"), ("tool-switch", "m8"), ("program-end", "m30")).Text;

        Assert.Equal("(CncEngraver, grbl, mm)\nG21 G17 G90 G91.1\nG94 G40 G49 G80\nG57 G61\nM9\nG0 X43.3333 Y0\nM8\nG2 X43.3333 Y0 I-3.3333 J0 F1200\nM9\nM30\n", text);
    }

    [Fact]
    public void A_tool_on_an_output_and_a_tolerance_are_for_LinuxCNC_only()
    {
        var low = new MachineProfile { ToolOutput = 3, ToolActiveLow = true, ToolSettleSeconds = 0.0 };
        Assert.Contains("G54 G64 P0.01\nM64 P2\nG0 X0 Y0\nM65 P2\nG1 X20 Y0 F1200\n", Written([s_slot], low, ("tool-switch", "m64"), ("blend", "0.01")).Text, StringComparison.Ordinal);
        Assert.Equal("PST0010 PST0010", Ids(Written([s_slot], low, ("tool-switch", "m64"), ("blend", "0.01"), ("dialect", "grbl"))));
        Assert.Equal("PST0013", Ids(Written([s_slot], low with { Spindle = new Spindle() })));
    }

    [Fact]
    public void A_tool_axis_plunges_at_its_feed_in_passes_and_a_slope_goes_down_no_faster()
    {
        var mill = MachineProfile.Default with { Height = new HeightDrive { CutDepth = 1.5, DepthPerPass = 1.0 }, Spindle = new Spindle() };
        var text = new GcodePost().Write(Request([[new StrokeMove(Line(0, 0, 3, 0).Line is var line ? Segment.FromLine(line) : default, 0, 0.0, -4.0)]], mill, ("spindle-speed", "12000"))).Text;

        Assert.Equal(
            """
            G0 Z5
            M3 S12000
            G4 P2
            G0 X0 Y0
            G0 Z1
            G1 Z3.5 F300
            """.Split('\n')[..4], text.Split('\n')[5..9]);
        Assert.Equal(6, text.Split('\n').Count(row => row.StartsWith("G1 X3", StringComparison.Ordinal)));
        Assert.Contains("\nG1 Z-1.5 F300\nG1 X3 Y0 Z-5.5 F375\nG0 Z5\nM5\nM2\n%\n", text, StringComparison.Ordinal); // 5 mm of path for 4 mm down
    }

    [Fact]
    public void Heights_that_cannot_be_cut_and_places_that_cannot_be_said_are_findings()
    {
        var mill = MachineProfile.Default with { Height = new HeightDrive() };
        Assert.Equal("MOT0014", Ids(new GcodePost().Write(Request([[new StrokeMove(Line(0, 0, 1, 0), 0, -1.0, 2.0)]], mill))));
        Assert.Equal("PST0011", Ids(Written([[Line(0, 0, 2e5, 0)]])));
        Assert.Equal("DOC0002", Ids(Written([])));
    }

    /// <summary>Rounded ends, a rounded centre and small or flat arcs: for any drawing both controllers accept the program, and its distance from the drawing
    /// is at most a few units.</summary>
    [Theory]
    [InlineData("linuxcnc", GcodeController.LinuxCnc, 4e-6)]
    [InlineData("grbl", GcodeController.Grbl, 6e-4)]
    public async Task Seeded_arcs_of_every_size_are_taken_by_the_controllers_rules_and_stay_on_their_place(string dialect, GcodeController controller, double allowed)
    {
        var random = new Random(274);
        for (var number = 0; number < 300; number++)
        {
            var radius = Math.Pow(10.0, (random.NextDouble() * 7.0) - 2.5);
            var sweep = Math.Pow(10.0, (random.NextDouble() * 5.0) - 2.5);
            var arc = Arc((random.NextDouble() - 0.5) * 200.0, (random.NextDouble() - 0.5) * 200.0, radius, random.NextDouble() * 360.0, Math.Min(sweep, 359.9) * (random.Next(2) == 0 ? 1.0 : -1.0));
            if (arc.Length < 0.01) continue;
            var text = Written([[arc]], MachineProfile.Default with { FeedMmPerMinute = 600.0 }, ("dialect", dialect)).Text;
            var (found, told) = await RecordingJudge.ReadAsync(new GcodeReader(controller), text);

            Assert.Equal("", found);
            var why = FormattableString.Invariant($"{radius} {arc.Arc.Sweep.Degrees}\n{text}");
            Assert.True(Math.Abs(told.Cuts.Sum(cut => cut.Length) - arc.Length) <= 1e-3 * arc.Length + 0.001, why);
            foreach (var cut in told.Cuts) for (var i = 0; i <= 4; i++) Assert.True(arc.DistanceTo(cut.PointAt(i / 4.0)) <= allowed, why);
        }
    }

    [Fact]
    public void A_line_of_a_program_for_grbl_is_never_longer_than_it_takes()
    {
        var text = Written([[Line(-99_998.123456, -99_998.123456, 99_998.123456, 99_998.123456), Arc(99_000.123456, -99_000.123456, 900.987654, 12.3, -200.1)]], MachineProfile.Default with { FeedMmPerMinute = 1234.5678 }, ("dialect", "grbl")).Text;

        Assert.All(text.Split('\n'), row => Assert.InRange(row.Length, 0, 79));
    }

    [Fact]
    public void Numbers_are_written_with_points_whatever_the_culture()
    {
        var here = CultureInfo.CurrentCulture;
        try
        {
            CultureInfo.CurrentCulture = new CultureInfo("de-DE");
            Assert.Contains("G1 X1.5 Y-2.25 F1200.5", Written([[Line(0, 0, 1.5, -2.25)]], new MachineProfile { FeedMmPerMinute = 1200.5 }).Text, StringComparison.Ordinal);
        }
        finally
        {
            CultureInfo.CurrentCulture = here;
        }
    }

    private static PostOutput Written(Segment[][] strokes, MachineProfile? machine = null, params (string Name, string Value)[] options) =>
        new GcodePost().Write(Request([.. strokes.Select(segments => segments.Select((segment, entity) => new StrokeMove(segment, entity)).ToArray())], machine ?? MachineProfile.Default, options));

    private static PostRequest Request(StrokeMove[][] strokes, MachineProfile machine, params (string Name, string Value)[] options) =>
        UsualOptions.Post(new Toolpath(default, [.. strokes.Select((moves, index) => new ToolpathStroke(index, Closed: false, moves))]), null, null, options.ToDictionary(option => option.Name, option => option.Value)) with { Machine = machine };

    private static string Ids(PostOutput written) => string.Join(' ', written.Diagnostics.Select(finding => finding.Id));

    private static Segment Line(double x1, double y1, double x2, double y2) => Segment.FromLine(new Point2D(x1, y1), new Point2D(x2, y2));

    private static Segment Arc(double x, double y, double radius, double start, double sweep) => Segment.FromArc(new ArcSegment(new Point2D(x, y), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep)));
}
