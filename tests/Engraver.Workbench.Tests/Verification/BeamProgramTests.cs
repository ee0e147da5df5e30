using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Operations;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>Operations of a beam as programs: its power, and what no target but G-code has.</summary>
public class BeamProgramTests
{
    private const string Powers = """
        { "id": "mark", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "power": 12.5 },
        { "id": "plain", "kind": "engrave", "select": {"layers": ["PLAIN"]}, "tool": 1 },
        { "id": "cut", "kind": "profile", "side": "outside", "select": {"layers": ["CUT"]}, "tool": 2, "power": 100, "repeats": 2 }
        """;

    private const string Filled = """{ "id": "area", "kind": "fill", "select": {"layers": ["CUT"]}, "tool": 2, "power": 60, "feed": 900, "spacing": 3, "overscan": 2.5 }""";

    /// <summary>A percentage of the full power, which is --spindle-speed; the speed of a tool is the S word of an operation without power only.</summary>
    [Theory]
    [InlineData("linuxcnc", "m3")]
    [InlineData("grbl", "m3")]
    [InlineData("grbl", "m4")]
    public async Task Each_operation_has_its_part_of_the_full_power(string dialect, string code)
    {
        var options = Options(dialect, code, "800");
        var text = Posted(Powers, options).Text!;

        Assert.Equal([$"{code.ToUpperInvariant()} S100", $"{code.ToUpperInvariant()} S350", $"{code.ToUpperInvariant()} S800", $"{code.ToUpperInvariant()} S800"], text.Split('\n').Where(line => line.Contains(" S", StringComparison.Ordinal)));
        Assert.Equal("", string.Join(' ', (await VerifyAsync(text, Powers, options)).Diagnostics.Select(finding => finding.Message)));
        foreach (var (was, becomes) in new[] { (" S100", " S101"), (" S800", " S400"), (" S350", " S100"), (code.ToUpperInvariant() + " S100", (code == "m3" ? "M4" : "M3") + " S100") })
        {
            var at = text.IndexOf(was, StringComparison.Ordinal);
            Assert.Equal("VER0013", (await VerifyAsync(text[..at] + becomes + text[(at + was.Length)..], Powers, options)).Diagnostics[0].Id);
        }
    }

    [Theory]
    [InlineData("linuxcnc", "m4", "", "PST0010")] // M4 is another direction of a spindle there
    [InlineData("linuxcnc", "m64", "", "OPR0037")]
    [InlineData("grbl", "m8", "", "OPR0037")]
    [InlineData("grbl", "m4", ", \"pierce\": 1", "OPR0037")] // the beam is off at rest
    public void What_a_dialect_or_a_switch_does_not_have_is_refused_by_name(string dialect, string code, string more, string expected)
    {
        var posted = Posted($$"""{ "id": "mark", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "power": 50{{more}} }""", Options(dialect, code));

        Assert.Null(posted.Text);
        Assert.Equal(expected, Assert.Single(posted.Diagnostics, finding => finding.Severity == Severity.Error).Id);
    }

    [Fact]
    public void A_beam_that_pierces_is_on_before_it_moves_in_the_laser_mode_too()
    {
        const string pierced = """{ "id": "mark", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "power": 50, "pierce": 1.5 }""";

        Assert.Contains("\nG1 M3 S500 F1200\nG4 P1.6\nG1 X9 Y8\n", Posted(pierced, Options("grbl", "m3")).Text!, StringComparison.Ordinal);
        Assert.Contains("\nM3 S500\nG4 P1.6\nG1 X9 Y8 F1200\n", Posted(pierced, Options("linuxcnc", "m3")).Text!, StringComparison.Ordinal);
    }

    /// <summary>S0 before and behind each line, whose own motion has the power.</summary>
    [Fact]
    public async Task A_line_of_a_fill_is_entered_and_left_at_full_speed_with_the_beam_off()
    {
        var options = Options("grbl", "m4");
        var text = Posted(Filled, options).Text!;

        Assert.Contains("\nG0 X-2.4 Y1.5\nM4 S0\nG1 X0.1 Y1.5 F900 S0\nG1 X11.9 Y1.5 S600\nG1 X14.4 Y1.5 S0\nM5\n", text, StringComparison.Ordinal);
        Assert.Equal("", string.Join(' ', (await VerifyAsync(text, Filled, options)).Diagnostics.Select(finding => finding.Message)));
        Assert.Contains(JobPreparation.Prepare(Plate(), Settings(Filled) with { Placement = DrawingPlacement.None with { Blank = new Vector2D(12, 12) } }, MotionStyle.Calls).Findings, finding => finding is { Id: "PLC0003", Facts: ["2.4"] });
    }

    [Theory]
    [InlineData(", \"angle\": 33, \"cross\": true")]
    [InlineData(", \"angle\": -71.3, \"inset\": 0.01, \"spacing\": 0.37")]
    public async Task A_fill_in_any_direction_is_accepted(string more)
    {
        var operations = Filled.Replace("\"CUT\"", "\"ROUND\"", StringComparison.Ordinal).Replace(more.Contains("spacing", StringComparison.Ordinal) ? "\"spacing\": 3, " : "\"none\"", "", StringComparison.Ordinal).Replace(" }", more + " }", StringComparison.Ordinal);

        Assert.Equal("", string.Join(' ', (await VerifyAsync(Posted(operations, Options("grbl", "m4")).Text!, operations, Options("grbl", "m4"))).Diagnostics.Select(finding => finding.Message)));
    }

    [Theory]
    [InlineData("M4 S0\nG1 X0.1 Y1.5 F900 S0", "M4 S600\nG1 X0.1 Y1.5 F900", "VER0013")]
    [InlineData("G1 X11.9 Y1.5 S600", "G1 X11.9 Y1.5 S0", "VER0013")]
    [InlineData("G1 X14.4 Y1.5 S0", "G1 X14.4 Y1.5", "VER0013")]
    [InlineData("G1 X14.4 Y1.5 S0\n", "", "VER0013")]
    [InlineData("G1 X14.4 Y1.5 S0", "G1 X14.2 Y1.5 S0", "VER0013")]
    [InlineData("G1 X14.4 Y1.5 S0", "G1 X14.4 Y2.5 S0", "VER0013")]
    [InlineData("G1 X14.4 Y1.5 S0", "G1 X14.4 Y1.5 F600 S0\nF900", "VER0013")]
    [InlineData("G0 X-2.4 Y1.5", "G0 X-2 Y1.5", "VER0013")]
    [InlineData("G1 X0.1 Y1.5 F900 S0\n", "G0 X0.1 Y1.5 F900\n", "VER0013")]
    [InlineData("G1 X0.1 Y1.5 F900 S0\n", "G1 X0.1 Y1.5 F600 S0\nF900\n", "VER0013")]
    [InlineData("G0 X-2.4 Y1.5", "G1 X-2.4 Y1.5 F900 S0", "VER0013")]
    public async Task A_beam_that_is_on_beside_the_line_or_off_on_it_and_a_shorter_way_are_found(string was, string becomes, string id)
    {
        var options = Options("grbl", "m4");
        var text = Posted(Filled, options).Text!;
        var at = text.IndexOf(was, StringComparison.Ordinal);
        Assert.InRange(at, 0, text.Length);

        var report = await VerifyAsync(text[..at] + becomes + text[(at + was.Length)..], Filled, options);

        Assert.Equal((false, id), (report.Ok, report.Diagnostics.Select(finding => finding.Id).FirstOrDefault()));
    }

    [Theory]
    [InlineData("gcode", "grbl", "m3", "gcode --tool-switch m3")]
    [InlineData("gcode", "linuxcnc", "m3", "gcode --tool-switch m3")]
    [InlineData("galil", "", "", "galil")]
    [InlineData("hpgl", "", "", "hpgl")]
    public void Other_targets_refuse_overscan_by_name(string target, string dialect, string code, string name)
    {
        var posted = PostedProgram.Create(Plate(), Settings(Filled.Replace("\"power\": 60, ", "", StringComparison.Ordinal)), PostTable.Find(target).Post, target == "gcode" ? Options(dialect, code) : PostedProgram.NoOptions);

        Assert.Null(posted.Text);
        Assert.Equal(name, Assert.Single(posted.Diagnostics, finding => finding is { Id: "OPR0037", Facts: [_, "overscan", "area"] }).Facts[0]);
        Assert.Equal("overscan", Assert.Single(JobPreparation.Prepare(Plate(), Settings(Filled.Replace("\"power\": 60, ", "", StringComparison.Ordinal)), MotionStyle.Calls).RunRefusals).Facts[1]);
    }

    [Theory]
    [InlineData("galil")]
    [InlineData("galil-calls")]
    [InlineData("hpgl")]
    public void Other_targets_refuse_power_by_name(string target)
    {
        var finding = Assert.Single(PostedProgram.Create(Plate(), Settings(Powers.Replace("\"tool\": 2", "\"tool\": 1", StringComparison.Ordinal)), PostTable.Find(target).Post, PostedProgram.NoOptions).Diagnostics, finding => finding.Facts is [_, "power", "mark"]);

        Assert.Equal(("OPR0037", target), (finding.Id, finding.Facts[0]));
    }

    [Fact]
    public void A_run_is_refused_and_a_machine_with_a_tool_axis_has_no_beam()
    {
        var job = JobPreparation.Prepare(Plate(), Settings(Powers), MotionStyle.Calls);
        var mill = JobPreparation.Prepare(Plate(), Settings(Powers) with { Machine = MachineProfile.Default with { Axes = MachineAxes.Default with { Z = new MachineAxis('C', 1000.0) }, Height = new HeightDrive() } }, MotionStyle.Calls);

        Assert.NotNull(job.Motion.Program);
        Assert.Equal([("OPR0037", "mark"), ("OPR0037", "cut")], job.RunRefusals.Select(finding => (finding.Id, finding.Facts[2])));
        Assert.Equal(["OPR0062", "OPR0011", "OPR0062"], mill.Faults.Select(finding => finding.Id));
    }

    private static Dictionary<string, string> Options(string dialect, string code, string full = "1000") => new() { ["dialect"] = dialect, ["tool-switch"] = code, ["spindle-speed"] = full };

    private static PostedProgram Posted(string operations, Dictionary<string, string> options) => PostedProgram.Create(Plate(), Settings(operations), PostTable.Find("gcode").Post, options);

    private static Task<VerificationReport> VerifyAsync(string text, string operations, Dictionary<string, string> options) =>
        ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), PostTable.Find("gcode").Dialects[options["dialect"]], Plate(), Settings(operations), progress: null, CancellationToken.None, PostParameters.Parse(options.GetValueOrDefault));

    private static DrawingSettings Settings(string operations) => new()
    {
        Operations = OperationFile.Parse($$"""{ "version": "1.0", "tools": [{"number": 1, "diameter": 0.2, "kind": "laser", "spindle": 350}, {"number": 2, "diameter": 0.2, "kind": "laser"}], "operations": [{{operations}}] }"""),
    };

    private static Drawing Plate() => new DrawingBuilder().OnLayer(Visible("CUT")).Square(0, 0, 12).OnLayer(Visible("PLAIN")).Line(3, 4, 9, 4).OnLayer(Visible("MARK")).Line(3, 8, 9, 8).OnLayer(Visible("ROUND")).Circle(30, 0, 7).Build();

    private static Layer Visible(string name) => new(name, On: true, Frozen: false, Plot: true);
}
