using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>Program content other than the path is compared with the job too: frame, switches, waits, tool, speeds, times.</summary>
public class TargetTermsTests
{
    [Theory]
    [InlineData("gcode", "G54 ", "G55 ", "VER0013")]
    [InlineData("gcode", "M3 S1000", "M4 S1000", "VER0013")]
    [InlineData("gcode", "M3 S1000", "M3 S100", "VER0013")]
    [InlineData("gcode", "M3 S1000", "M3", "VER0013")]
    [InlineData("gcode", "M3 S1000", "M8", "VER0010")] // and leaves the stroke on beside what M5 switches off
    [InlineData("gcode", "G4 P0.1", "G4 P100", "VER0013")]
    [InlineData("gcode", "G4 P0.1\n", "", "VER0013")]
    [InlineData("gcode", "M5\nG0", "M5 M0\nG0", "VER0013")]
    [InlineData("gcode", "M5\nG4", "M5\nM8\nM9\nG4", "VER0013")]
    [InlineData("gcode", "\nM2", "\nG4 P3\nM2", "VER0013")]
    [InlineData("gcode", "G0 X", "G1 F1200 X", "VER0013")]
    [InlineData("grbl", "M3 S1000", "M4 S1000", "VER0013")]
    [InlineData("hpgl", "SP1;", "SP2;", "VER0013")]
    [InlineData("hpgl", "SP0;\n", "", "VER0013")]
    [InlineData("hpgl", "VS2;\n", "", "VER0013")]
    [InlineData("hpgl", "VS2;", "VS2,2;", "VER0013")]
    [InlineData("xps-linearc", "FirstTangent = 0\n", "FirstTangent = 90\n", "VER0013")]
    [InlineData("xps-linearc", "DiscontinuityAngle = 0.01", "DiscontinuityAngle = 90", "VER0013")]
    [InlineData("xps-linearc", "DiscontinuityAngle = 0.01", "DiscontinuityAngle = 0", "VER0013")]
    [InlineData("xps-linearc", "Arc = 3.000000, 360", "Arc = 3.000000, 450", "VER0014")]
    [InlineData("xps-spline", ",0\n", ",1\n", "VER0013")]
    [InlineData("xps-pvt", "20.000000, 0.000000, 0.000000", "21.000000, 0.000000, 0.000000", "VER0013")]
    [InlineData("cldata", "\n31\n0.0\n1001", "\n31\n1.0\n1001", "VER0013")]
    [InlineData("galil", "WT 100", "WT 1000", "VER0015")]
    [InlineData("galil", "VS 20000", "VS 20400", "VER0015")]
    [InlineData("galil", "VS 20000;VA 256000", "VS 20000;VA 128000", "VER0015")]
    [InlineData("galil", "SPA=50000", "SPA=25000", "VER0015")]
    [InlineData("galil", "DCA=256000", "DCA=25600", "VER0015")]
    [InlineData("galil-calls", "f=20000", "f=2000", "VER0015")]
    [InlineData("galil-calls", "SB1;WT 100", "SB1;WT 2", "VER0015")]
    public async Task Another_frame_switch_wait_tool_or_speed_is_noticed(string target, string was, string becomes, string id)
    {
        var text = Text(Plate(), new DrawingSettings(), target);
        Assert.True((await VerifyAsync(Plate(), new DrawingSettings(), target, text)).Ok);
        var at = text.IndexOf(was, StringComparison.Ordinal);
        Assert.InRange(at, 0, text.Length);
        var report = await VerifyAsync(Plate(), new DrawingSettings(), target, text[..at] + becomes + text[(at + was.Length)..]);

        Assert.False(report.Ok);
        Assert.Equal(id, report.Diagnostics[0].Id);
    }

    [Theory]
    [InlineData("M3 S1000", "M4 S1000")]
    [InlineData("G4 P2\n", "G4 P0.2\n")]
    [InlineData("G4 P2\n", "")]
    [InlineData("M3 S1000", "M3 S1000 M8")]
    [InlineData("M3 S1000", "M3 S900")]
    [InlineData("G0 Z5\nG0", "G1 F1200 Z5\nG0")]
    public async Task A_spindle_turns_its_way_as_fast_as_asked_and_is_waited_for(string was, string becomes)
    {
        var settings = new DrawingSettings { Machine = MachineProfile.Default with { Axes = MachineAxes.Default with { Z = new MachineAxis('C', 1000.0) }, Height = new HeightDrive { CutDepth = 1.0 }, Spindle = new Spindle() } };
        var text = Text(Plate(), settings, "gcode");
        Assert.True((await VerifyAsync(Plate(), settings, "gcode", text)).Ok);
        Assert.Contains(was, text, StringComparison.Ordinal);
        var report = await VerifyAsync(Plate(), settings, "gcode", text.Replace(was, becomes, StringComparison.Ordinal));

        Assert.Equal((false, "VER0013"), (report.Ok, report.Diagnostics[0].Id));
    }

    /// <summary>The post options are passed to the verification, which compares the program with them.</summary>
    [Theory]
    [InlineData("gcode", "work-offset", "G57")]
    [InlineData("gcode", "tool-switch", "m8")]
    [InlineData("gcode", "tool-switch", "m64")]
    [InlineData("gcode", "spindle-speed", "250.5")]
    [InlineData("hpgl", "pen", "3")]
    public async Task What_was_chosen_for_the_post_must_be_said_and_is_then_held_against_the_program(string target, string option, string value)
    {
        var text = PostedProgram.Create(Plate(), new DrawingSettings(), PostTable.Find(target).Post, new Dictionary<string, string> { [option] = value }).Text!;
        var said = PostParameters.Parse(name => name == option ? value : null);

        Assert.True((await VerifyAsync(Plate(), new DrawingSettings(), target, text, said)).Ok);
        Assert.Equal("VER0013", Assert.Single((await VerifyAsync(Plate(), new DrawingSettings(), target, text)).Diagnostics).Id);
    }

    /// <summary>One part in a thousand is within the allowed rounding of a feed (docs/cli-contract.md, verify).</summary>
    [Theory]
    [InlineData("F1201", true)]
    [InlineData("F1202", false)]
    public async Task A_feed_is_the_jobs_within_a_thousandth(string feed, bool isOk) =>
        Assert.Equal(isOk, (await VerifyAsync(Plate(), new DrawingSettings(), "gcode", Text(Plate(), new DrawingSettings(), "gcode").Replace("F1200", feed, StringComparison.Ordinal))).Ok);

    private static string Text(Drawing drawing, DrawingSettings settings, string target) => target == "grbl"
        ? PostedProgram.Create(drawing, settings, PostTable.Find("gcode").Post, new Dictionary<string, string> { ["dialect"] = "grbl" }).Text!
        : PostedProgram.Create(drawing, settings, PostTable.Find(target).Post, PostedProgram.NoOptions).Text!;

    private static Task<VerificationReport> VerifyAsync(Drawing drawing, DrawingSettings settings, string target, string text, PostParameters? posted = null) => ProgramVerification.VerifyAsync(
        ReadBackFile.FromText(text), target == "grbl" ? PostTable.Find("gcode").Dialects["grbl"] : PostTable.Find(target).Reader!, drawing, settings, progress: null, CancellationToken.None, posted);

    private static Drawing Plate() => new DrawingBuilder().Line(0, 0, 20, 0).Line(20, 0, 20, 10).Line(20, 10, 0, 10).Line(0, 10, 0, 0).Circle(10, 5, 3).Build();
}
