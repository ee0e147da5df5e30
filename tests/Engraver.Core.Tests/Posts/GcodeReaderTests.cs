using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts.GcodeReading;

namespace Engraver.Core.Tests.Posts;

/// <summary>rs274-hpgl.md 1 and 2: the rules and the published samples of the two controllers.</summary>
public class GcodeReaderTests
{
    private const double Round = 1e-9;

    /// <summary>The samples of the published pages of G2 and G3: centre, radius and sweep of each.</summary>
    [Theory]
    [InlineData("G0 X0 Y0\nM3\nG2 X1 Y1 I1 F10", 1, 0, 1, -90)]
    [InlineData("G0 X0 Y0\nM3\nG3 X1 Y1 J1 F10", 0, 1, 1, 90)]
    [InlineData("G0 X7 Y7\nM3\nG17 G2 x 10 y 16 i 3 j 4 F1", 10, 11, 5, -143.13010235415598)]
    [InlineData("G0 X0 Y0\nM3\nG2 X0 Y1 R0.5 F1", 0, 0.5, 0.5, -180)]
    [InlineData("G0 X0 Y0\nM3\nG2 X0 Y0 I1 J0 F1", 1, 0, 1, -360)]
    [InlineData("G0 X0 Y0\nM3\nG3 I-2 F1", -2, 0, 2, 360)]
    [InlineData("G0 X10 Y0\nM3\nG3 X0 Y10 R10 F1", 0, 0, 10, 90)]
    [InlineData("G0 X10 Y0\nM3\nG3 X0 Y10 R-10 F1", 10, 10, 10, 270)]
    [InlineData("G0 X10 Y0\nM3\nG2 X0 Y-10 R-10 F1", 10, -10, 10, -270)]
    [InlineData("G90.1 G0 X5 Y3\nM3\nG2 X3 Y5 I3 J3 F1", 3, 3, 2, -270)]
    [InlineData("G20 G0 X1 Y0\nM3\nG2 X0 Y-1 I-1 F1", 0, 0, 25.4, -90)]
    [InlineData("G0 X1 Y1\nG91 M3\nG3 X-2 Y0 I-1 F1", 0, 1, 1, 180)]
    public async Task An_arc_is_the_one_that_its_words_mean(string text, double x, double y, double radius, double sweep)
    {
        var (found, told) = await RecordingJudge.ReadAsync(new GcodeReader(), text + "\nM5\nM2\n");

        Assert.Equal("", found);
        Assert.Equal(sweep, told.Cuts.Sum(cut => cut.Arc.Sweep.Degrees), 1e-6);
        Assert.All(told.Cuts, cut => Assert.InRange(cut.Arc.Centre.DistanceTo(new Point2D(x, y)), 0.0, Round));
        Assert.All(told.Cuts, cut => Assert.Equal(radius, cut.Arc.Radius, Round));
        Assert.Equal(radius * Math.Abs(sweep) * Math.PI / 180.0, told.Cuts.Sum(cut => cut.Length), 1e-6);
    }

    /// <summary>Ends may differ by 0.005 mm, or by 0.1 % of the radius, and never by more than 0.5 mm.</summary>
    [Theory]
    [InlineData("G2 X1 Y1.0049 I1 F1", true)]
    [InlineData("G2 X2.0049 Y0 I1 F1", true)]
    [InlineData("G2 X2.0051 Y0 I1 F1", false)]
    [InlineData("G2 X200.09 Y0 I100 F1", true)]
    [InlineData("G2 X200.11 Y0 I100 F1", false)]
    [InlineData("G2 X2000.49 Y0 I1000 F1", true)]
    [InlineData("G2 X2000.51 Y0 I1000 F1", false)]
    [InlineData("G2 X2 Y0 F1 R0.998", false)]
    [InlineData("G2 X2 Y0 F1 R0.999", true)]
    public async Task The_ends_of_an_arc_are_as_far_from_its_centre_as_the_controllers_demand(string arc, bool isTaken) =>
        Assert.Equal(isTaken ? "" : "PST0001@3", (await RecordingJudge.ReadAsync(new GcodeReader(), $"G0 X0 Y0\nM3\n{arc}\nM2\n")).Findings);

    [Theory]
    [InlineData("G61", "G1 X9", 0.0)]
    [InlineData("G61.1", "G1 X9", 0.0)]
    [InlineData("G64 P0.05", "G1 X9", 0.1)] // lines are joined within the same
    [InlineData("G64 P0.05 Q0.01", "G1 X9", 0.06)]
    [InlineData("G64 P0.05 Q0", "G1 X9", 0.05)]
    [InlineData("G64 P0.05", "G2 X9 I4.5", 0.05)] // arcs are not
    [InlineData("G64 P0.002 G20", "G21 G1 X9", 0.1016)] // the unit first
    [InlineData("G64 P3", "G1 X9", 6.0)]
    [InlineData("G64", "G1 X9", double.PositiveInfinity)]
    [InlineData("G64 P0", "G1 X9", double.PositiveInfinity)]
    [InlineData("G64 Q0.1", "G1 X9", double.PositiveInfinity)]
    [InlineData("", "G1 X9", double.PositiveInfinity)] // as at the start of the controller
    [InlineData("G64\nG61", "G1 X9", 0.0)]
    [InlineData("G64", "M5 G1 X9", 0.0)] // nothing is cut
    public async Task How_far_path_control_may_leave_the_path_is_told_with_the_first_cut_under_it(string mode, string cut, double most)
    {
        var text = $"G0 X0 Y0\n{mode}\nM3\nF600\n{cut}\nM5\nM2\n";
        var (found, told) = await RecordingJudge.ReadAsync(new GcodeReader(), text);

        Assert.Equal("", found);
        Assert.Equal(most, told.Blends.Largest, 1e-12);
        Assert.Equal(most == 0.0 ? 0 : text.Split('\n').ToList().IndexOf(cut) + 1, told.Blends.Line);
    }

    /// <summary>Regression: programs that plunge, or that cut with the tool off, were reported as equal to the drawing.</summary>
    [Theory]
    [InlineData("G1 X9 Z-5")]
    [InlineData("G1 Z-5")]
    [InlineData("G0 Z5")]
    [InlineData("G2 X2 Y0 I1 Z-1")]
    public async Task A_program_that_moves_Z_is_refused_for_a_machine_without_a_tool_axis(string move) =>
        Assert.Equal("PST0001@4", (await RecordingJudge.ReadAsync(new GcodeReader(), $"G0 X0 Y0\nM3\nF600\n{move}\nM5\nM2\n")).Findings);

    [Fact]
    public async Task A_beam_of_no_power_cuts_nothing()
    {
        var (found, told) = await RecordingJudge.ReadAsync(new GcodeReader(), "G0 X0 Y0\nM3 S0\nF600\nG1 X9\nS500\nG1 X12\nM5\nM2\n");

        Assert.Equal("", found);
        var cut = Assert.Single(told.Cuts);
        Assert.Equal((new Point2D(9.0, 0.0), new Point2D(12.0, 0.0)), (cut.Start, cut.End));
    }

    [Theory]
    [InlineData("M3 S1000", "")]
    [InlineData("M3", "")]
    [InlineData("M3 S0", "PST0001@4")]
    [InlineData("M5", "PST0001@4")]
    public async Task A_cutter_goes_down_only_with_its_spindle_turning(string spindle, string expected)
    {
        var mill = MachineProfile.Default with { Height = new HeightDrive(), Spindle = new Spindle() };

        Assert.Equal(expected, (await RecordingJudge.ReadAsync(new GcodeReader(), $"G0 Z{mill.Height.RetractHeight}\nG0 X0 Y0\n{spindle}\nG1 Z-1 F300\nG1 X9\nG0 Z{mill.Height.RetractHeight}\nM5\nM2\n", mill)).Findings);
    }

    [Fact]
    public async Task Grbl_runs_every_path_exactly() => Assert.Equal(0.0, (await RecordingJudge.ReadAsync(new GcodeReader(GcodeController.Grbl), "G0 X0 Y0\nM3\nG1 X9 F600\nM5\nM2\n")).Told.Blends.Largest);

    /// <summary>rs274-hpgl.md 1.3: from a radius of 1 mm to an end 1.004 mm from the centre.</summary>
    [Fact]
    public async Task An_arc_whose_ends_are_not_as_far_from_the_centre_spirals_on_LinuxCNC_and_keeps_its_first_radius_on_grbl()
    {
        const string Arc = "G0 X0 Y0\nM3\nG2 X2.004 Y0 I1 F600\nM5\nM2\n";
        var spiral = (await RecordingJudge.ReadAsync(new GcodeReader(), Arc)).Told.Cuts;
        var round = (await RecordingJudge.ReadAsync(new GcodeReader(GcodeController.Grbl), Arc)).Told.Cuts;

        Assert.All(spiral.Zip(spiral.Skip(1)), pair => Assert.True(pair.First.Arc.Radius < pair.Second.Arc.Radius));
        Assert.All(round.SkipLast(1), cut => Assert.Equal(1.0, cut.Arc.Radius, Round));
        Assert.Equal(-180.0, round.SkipLast(1).Sum(cut => cut.Arc.Sweep.Degrees), 1e-9);
        Assert.Equal(SegmentKind.Line, round[^1].Kind);
        Assert.InRange(round[^1].Start.DistanceTo(new Point2D(2.0, 0.0)), 0.0, Round);
        Assert.Equal(new Point2D(2.004, 0.0), round[^1].End);
    }

    [Fact]
    public async Task Grbl_holds_the_difference_of_the_ends_against_the_first_radius()
    {
        const string Arc = "G0 X0 Y0\nM3\nG2 X200.10005 Y0 I100 F600\nM5\nM2\n";

        Assert.Equal("", (await RecordingJudge.ReadAsync(new GcodeReader(), Arc)).Findings);
        Assert.Equal("PST0001@3", (await RecordingJudge.ReadAsync(new GcodeReader(GcodeController.Grbl), Arc)).Findings);
    }

    [Theory]
    [InlineData("g1x1y2f600")]
    [InlineData("N10 G 1 X 1 . 0 Y +2 F600")]
    [InlineData("G1 (a comment) X1.(another)Y2 F600 ; the rest X9")]
    [InlineData("X1 Y2 G01 F600")]
    [InlineData("F600 G1 X1 Y2 M3 S5")]
    public async Task Spaces_case_order_and_comments_mean_nothing(string line)
    {
        var (found, told) = await RecordingJudge.ReadAsync(new GcodeReader(), $"G0 X0 Y0\nM3\n{line}\nM30\n");

        Assert.Equal(("", new Point2D(1, 2)), (found, Assert.Single(told.Cuts).End));
        Assert.Null(told.Feeds.Finding);
    }

    [Theory]
    [InlineData("G1 X1")] // no feed yet
    [InlineData("G18")]
    [InlineData("G28")]
    [InlineData("G53 G0 X1")]
    [InlineData("G92 X0")]
    [InlineData("G81 X1 Z1 R2 F1")]
    [InlineData("G41 D1")]
    [InlineData("G93")]
    [InlineData("G1 G2 X1 F1")]
    [InlineData("G20 G21")]
    [InlineData("G1 X1 X2 F1")]
    [InlineData("G1 X#1 F1")]
    [InlineData("G1 X[1+1] F1")]
    [InlineData("#1=2")]
    [InlineData("O100 sub")]
    [InlineData("/G1 X1 F1")]
    [InlineData("G1 X1.2.3 F1")]
    [InlineData("G1 X- F1")]
    [InlineData("G1 X1e3 F1")]
    [InlineData("G1 X1 F-1")]
    [InlineData("G1 X1 (open")]
    [InlineData("G1 X1 (a (b) F1")]
    [InlineData("G1 X1 A1 F1")]
    [InlineData("G1 X1 N5 F1")]
    [InlineData("N1.5 G1 X1 F1")]
    [InlineData("N100000 G1 X1 F1")]
    [InlineData("G2 X1 Y1 F1")]
    [InlineData("G2 X1 Y1 I1 R1 F1")]
    [InlineData("G2 X1 Y1 K1 F1")]
    [InlineData("G3 X0 Y0 R1 F1")]
    [InlineData("G2 I0 J0 F1")]
    [InlineData("G2 X1 Y1 I1 P2 F1")]
    [InlineData("G1 X1 I1 F1")]
    [InlineData("G90.1 G2 X1 Y1 I1 F1")]
    [InlineData("G80 X1")]
    [InlineData("G4")]
    [InlineData("G4 P-1")]
    [InlineData("G4 P1 X1")]
    [InlineData("G64 P-1")]
    [InlineData("G64 P1 Q-1")]
    [InlineData("G1 X1 Q2 F1")]
    [InlineData("G20 F5")]
    [InlineData("G55")]
    [InlineData("M6 T1")]
    [InlineData("M64")]
    [InlineData("M3 M5")]
    [InlineData("M98 P1")]
    [InlineData("G1 X1 P1 F1")]
    [InlineData("%")]
    [InlineData("ü")]
    public async Task What_a_controller_refuses_or_the_program_does_not_say_is_one_finding_at_its_line(string line) =>
        Assert.Equal("PST0001@3", (await RecordingJudge.ReadAsync(new GcodeReader(), $"G54 G0 X0 Y0\nM3\n{line}\nM2\n")).Findings);

    [Theory]
    [InlineData("", "VER0001@0")]
    [InlineData("(nothing)\n\n", "VER0001@0")]
    [InlineData("M2\n", "VER0001@0")]
    [InlineData("G0 X1 Y1\n", "PST0001@1")] // no end
    [InlineData("%\nG0 X1 Y1\nM2\n", "PST0001@3")] // and no second mark
    [InlineData("%\nG0 X1 Y1\nM2\n%\nanything behind the mark", "")]
    [InlineData("G0 X1 Y1\nM30\n\n\n", "")]
    [InlineData("G0 X1 Y1\nM2\nG0 X2\n", "PST0001@3")]
    [InlineData("G1 X1 Y1 F5\nM2\n", "")]
    [InlineData("G1 X1 F5\nM2\n", "PST0001@1")] // from where in Y?
    [InlineData("G91 G1 X1 Y1 F5\nM2\n", "PST0001@1")]
    [InlineData("G2 X1 Y1 I1 F5\nM2\n", "PST0001@1")]
    [InlineData("G0 X1 Y1\nM64 P0\nG1 X2 F5\nM2\n", "PST0001@4")] // the output stays on
    public async Task A_program_has_an_end_and_says_where_it_begins(string text, string findings) => Assert.Equal(findings, (await RecordingJudge.ReadAsync(new GcodeReader(), text)).Findings);

    [Theory]
    [InlineData("%\nG0 X0 Y0\nM2\n%", "PST0001@1")]
    [InlineData("N9999999 G0 X0 Y0\nM2", "")]
    [InlineData("N10000000 G0 X0 Y0\nM2", "PST0001@1")]
    [InlineData("G0 X0 Y0\nG2 I1 F5\nM2", "PST0001@2")] // grbl requires the end of an arc, also of a circle
    [InlineData("G0 X0 Y0\nG2 X0 I1 F5\nM2", "")]
    [InlineData("G90.1\nG0 X0 Y0\nM2", "PST0001@1")]
    [InlineData("G64 P0.1\nG0 X0 Y0\nM2", "PST0001@1")]
    [InlineData("M64 P0\nG0 X0 Y0\nM2", "PST0001@1")]
    [InlineData("G59.1\nG0 X0 Y0\nM2", "PST0001@1")]
    [InlineData("G0 X00000000000000000000000000000000000000000000000000000000000000000000000001 Y0\nM2", "")] // 79 characters that count
    [InlineData("G0 X000000000000000000000000000000000000000000000000000000000000000000000000001 Y0\nM2", "PST0001@1")]
    [InlineData("G0 X0 Y0 (blanks and comments do not count, however many of them may stand on a line of it)\nM2", "")]
    public async Task Grbl_has_limits_of_its_own(string text, string findings) => Assert.Equal(findings, (await RecordingJudge.ReadAsync(new GcodeReader(GcodeController.Grbl), text)).Findings);

    [Fact]
    public async Task The_codes_of_a_line_are_done_in_the_order_of_the_language()
    {
        var (found, told) = await RecordingJudge.ReadAsync(new GcodeReader(), "G0 X0 Y0\nG1 X5 F600 M3\nM5 X9\nM2\n");

        Assert.Equal("", found);
        Assert.Equal((new Point2D(0, 0), new Point2D(5, 0)), (Assert.Single(told.Cuts).Start, told.Cuts[0].End)); // M3 before the motion, and M5 too
    }

    [Fact]
    public async Task A_tool_axis_tells_heights_and_a_rapid_into_the_work_is_no_feed()
    {
        var mill = MachineProfile.Default with { Axes = MachineAxes.Default with { Z = new MachineAxis('C', 1000.0) }, Height = new HeightDrive() };
        var (found, told) = await RecordingJudge.ReadAsync(new GcodeReader(), "G0 Z5\nG0 X1 Y1\nG0 Z1\nG1 Z-1 F300\nG2 X3 Y1 I1 Z-1.5 F600\nG0 Z5\nM2\n", mill);

        Assert.Equal(("", -1.5), (found, told.Feeds.Lowest));
        Assert.Empty(told.Cuts);
        Assert.All(told.Places.Where(place => place.Cutting), place => Assert.True(place.ZMm < 1.0));
        Assert.Contains(told.Places, place => place.Cutting && place.Place.IsNear(new Point2D(2, 2), 0.03) && Math.Abs(place.ZMm + 1.25) < 0.02); // half of the helix
        Assert.Equal("PST0001@1", (await RecordingJudge.ReadAsync(new GcodeReader(), "G0 X1 Y1\nM2\n", mill)).Findings);
        Assert.Equal("PST0001@3", (await RecordingJudge.ReadAsync(new GcodeReader(), "G0 X1 Y1 Z5\nG1 Z-1 F5\nM2\n", mill)).Findings);
    }
}
