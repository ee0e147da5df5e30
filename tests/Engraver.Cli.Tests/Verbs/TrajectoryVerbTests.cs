using System.Text.Json;

namespace Engraver.Cli.Tests.Verbs;

public class TrajectoryVerbTests
{
    private const string Circle = "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n5\nA1\n8\n0\n10\n100\n20\n50\n40\n10\n0\nENDSEC\n0\nEOF\n";

    [Fact]
    public async Task The_object_has_every_field_of_the_contract()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("trajectory", folder.WithFile("circle.dxf", Circle), "-o", folder.PathOf("out"), "--json");
        var one = Assert.Single(JsonText.Of(run).GetProperty("trajectories").EnumerateArray());

        Assert.Equal(0, run.ExitCode);
        Assert.Equal(["file", "source", "points", "maxError", "verifiedBound", "maxSpacingRatio", "length", "closed", "seconds"], one.EnumerateObject().Select(field => field.Name));
        Assert.Equal(("traj0_path.txt", "A1", 22, true), (one.GetProperty("file").GetString(), one.GetProperty("source").GetString(), one.GetProperty("points").GetInt32(), one.GetProperty("closed").GetBoolean()));
        Assert.InRange(one.GetProperty("verifiedBound").GetDouble(), one.GetProperty("maxError").GetDouble(), 0.001);
        Assert.Equal(20.0 * Math.PI, one.GetProperty("length").GetDouble(), precision: 9);
    }

    [Fact]
    public async Task The_text_is_exactly_that_of_the_plug_in()
    {
        using var folder = new TemporaryFolder();
        var line = folder.WithFile("line.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n5\nA1\n8\n0\n10\n1.5\n20\n-2\n11\n11.5\n21\n-2\n0\nENDSEC\n0\nEOF\n");
        var run = await CliRun.RunAsync("trajectory", line, "-o", folder.PathOf("out"), "--z", "-0.25");

        Assert.Equal(0, run.ExitCode);
        Assert.Equal("-8.5, -2, -0.25\r\n1.5, -2, -0.25\r\n11.5, -2, -0.25\r\n21.5, -2, -0.25\r\n", await File.ReadAllTextAsync(folder.PathOf("out/traj0_path.txt")));
    }

    [Fact]
    public async Task The_list_names_every_file_and_where_it_starts()
    {
        using var folder = new TemporaryFolder();
        await CliRun.RunAsync("trajectory", folder.WithFile("circle.dxf", Circle), "-o", folder.PathOf("out"), "--format", "xps-spline");
        using var list = JsonDocument.Parse(await File.ReadAllTextAsync(folder.PathOf("out/trajectories.json")));
        var one = Assert.Single(list.RootElement.GetProperty("trajectories").EnumerateArray());

        Assert.Equal("xps-spline", list.RootElement.GetProperty("format").GetString());
        Assert.Equal(50.0, one.GetProperty("start").GetProperty("y").GetDouble());
        Assert.InRange(one.GetProperty("start").GetProperty("x").GetDouble(), 89.999, 90.001); // the quadrant nearest to 0,0; points are a little beside the curve
        Assert.Equal("0,0,0", (await File.ReadAllLinesAsync(folder.PathOf("out/" + one.GetProperty("file").GetString())))[1]);
    }

    [Theory]
    [InlineData("--offset requires --side", "--offset", "2")]
    [InlineData("--side requires --offset", "--side", "in")]
    [InlineData("--step", "--offset", "2", "--side", "in", "--passes", "3")]
    [InlineData("--passes", "--offset", "2", "--side", "in", "--passes", "1.5", "--step", "1")]
    [InlineData("--max-error", "--max-error", "0")]
    [InlineData("--segment-length", "--segment-length", "-1")]
    [InlineData("--segment-length requires --density uniform", "--segment-length", "1", "--density", "dynamic")]
    [InlineData("--density uniform cannot be used with --format xps-pvt", "--segment-length", "1", "--format", "xps-pvt")]
    [InlineData("'pdf'", "--format", "pdf")]
    [InlineData("--density uniform cannot be used with --format xps-linearc", "--density", "uniform", "--format", "xps-linearc")]
    [InlineData("--density uniform cannot be used with --format xps-pvt", "--density", "uniform", "--format", "xps-pvt")]
    [InlineData("--corners continuous cannot be used with --format xps-linearc", "--corners", "continuous", "--format", "xps-linearc")]
    [InlineData("--corners continuous cannot be used with --format xps-pvt", "--corners", "continuous", "--format", "xps-pvt")]
    public async Task What_does_not_go_together_is_a_usage_error_and_writes_nothing(string says, params string[] options)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync(["trajectory", folder.WithFile("circle.dxf", Circle), "-o", folder.PathOf("out"), .. options]);

        Assert.Equal(2, run.ExitCode);
        Assert.Contains(says, run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(folder.PathOf("out")));
    }

    [Theory]
    [InlineData("xps-linearc")]
    [InlineData("xps-pvt")]
    public async Task The_sampled_error_is_measured_in_every_format(string format)
    {
        const string Ellipse = "0\nSECTION\n2\nENTITIES\n0\nELLIPSE\n5\nA1\n8\n0\n10\n100\n20\n50\n30\n0\n11\n10\n21\n0\n31\n0\n40\n0.5\n41\n0\n42\n6.283185307179586\n0\nENDSEC\n0\nEOF\n";
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("trajectory", folder.WithFile("ellipse.dxf", Ellipse), "-o", folder.PathOf("out"), "--json", "--format", format);
        var one = Assert.Single(JsonText.Of(run).GetProperty("trajectories").EnumerateArray());

        Assert.InRange(one.GetProperty("maxError").GetDouble(), 0.0001, one.GetProperty("verifiedBound").GetDouble());
    }

    [Fact]
    public async Task Offsets_come_in_passes_of_which_the_last_is_at_the_tools_radius()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("trajectory", folder.WithFile("circle.dxf", Circle), "-o", folder.PathOf("out"), "--json", "--offset", "2", "--side", "in", "--passes", "3", "--step", "1.5");
        var all = JsonText.Of(run).GetProperty("trajectories").EnumerateArray().ToList();

        Assert.Equal(["traj0_offset0-0.txt", "traj1_offset1-0.txt", "traj2_offset2-0.txt"], all.Select(one => one.GetProperty("file").GetString()));
        Assert.Equal([5.0, 6.5, 8.0], all.Select(one => Math.Round(one.GetProperty("length").GetDouble() / (2.0 * Math.PI), 9)));
    }

    [Fact]
    public async Task A_drawing_without_curves_is_an_error_with_its_object_and_no_file()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("trajectory", folder.WithFile("empty.dxf", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n"), "-o", folder.PathOf("out"), "--json");

        Assert.Equal(1, run.ExitCode);
        Assert.Equal(0, JsonText.Of(run).GetProperty("trajectories").GetArrayLength());
        Assert.False(Directory.Exists(folder.PathOf("out")));
    }

    [Fact]
    public async Task Equal_steps_that_leave_the_drawing_too_far_are_written_only_when_that_is_asked_for()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("trajectory", folder.WithFile("circle.dxf", Circle), "-o", folder.PathOf("out"), "--density", "uniform", "--segment-length", "6");
        var written = Directory.Exists(folder.PathOf("out"));
        var asked = await CliRun.RunAsync("trajectory", folder.PathOf("circle.dxf"), "-o", folder.PathOf("out"), "--density", "uniform", "--segment-length", "6", "--accept-errors");
        var kept = await CliRun.RunAsync("trajectory", folder.PathOf("circle.dxf"), "-o", folder.PathOf("kept"), "--density", "uniform", "--segment-length", "1");

        Assert.Equal((1, false, 1, 0), (run.ExitCode, written, asked.ExitCode, kept.ExitCode));
        Assert.Contains("error TRJ0008", run.Error, StringComparison.Ordinal);
        Assert.True(File.Exists(folder.PathOf("out/traj0_path.txt")));
    }

    [Fact]
    public async Task Equal_steps_that_leave_the_drawing_too_far_are_run_only_when_that_is_asked_for()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("circle.dxf", Circle);
        var made = await CliRun.RunAsync("script", folder.WithFile("a.scr", $"OPEN \"{drawing}\"\nSACETOGGLEDYNAMICDENSITY\nSACESETSTATICSEGMENTLENGTH 6\nSACEPATH ALL\n\nQSAVE\n"));
        var run = await CliRun.RunAsync("run", drawing, "--trajectory", "--connect", "sim:", "--json");
        var asked = await CliRun.RunAsync("run", drawing, "--trajectory", "--connect", "sim:", "--json", "--accept-errors");

        Assert.Equal((0, 1, 1), (made.ExitCode, run.ExitCode, asked.ExitCode));
        Assert.Contains("error TRJ0008", run.Error, StringComparison.Ordinal);
        Assert.Equal(("refused", "complete"), (JsonText.Of(run).GetProperty("outcome").GetString(), JsonText.Of(asked).GetProperty("outcome").GetString()));
    }

    [Theory]
    [InlineData("sace")]
    [InlineData("xps-spline")]
    [InlineData("xps-linearc")]
    [InlineData("xps-pvt")]
    public async Task What_trajectory_writes_verify_finds_ok_both_ways(string format)
    {
        using var folder = new TemporaryFolder();
        foreach (var drawing in (string[])["paper-001", "gasket"])
        {
            var output = folder.PathOf(drawing);
            var written = await CliRun.RunAsync("trajectory", SampleDrawing.PathOf(drawing), "-o", output, "--format", format);
            var run = await CliRun.RunAsync("verify", output, "--against", SampleDrawing.PathOf(drawing), "--target", format, "--json");
            var report = JsonText.Of(run);

            Assert.Equal((0, 0), (written.ExitCode, run.ExitCode));
            Assert.True(report.GetProperty("ok").GetBoolean());
            Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, 0.0010001);
            Assert.InRange(report.GetProperty("missingLength").GetDouble(), 0.0, 0.001);
        }
    }

    [Fact]
    public async Task A_file_that_was_changed_or_left_out_is_found_by_verify()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("circle.dxf", Circle);
        await CliRun.RunAsync("trajectory", drawing, "-o", folder.PathOf("out"), "--format", "xps-spline");
        var lines = (await File.ReadAllLinesAsync(folder.PathOf("out/traj0_path.txt"))).ToList();
        lines[8] = "1,1,0";
        await File.WriteAllLinesAsync(folder.PathOf("out/traj0_path.txt"), lines);
        var moved = await CliRun.RunAsync("verify", folder.PathOf("out/traj0_path.txt"), "--against", drawing, "--target", "xps-spline");
        await File.WriteAllLinesAsync(folder.PathOf("out/traj0_path.txt"), lines.Take(7));
        var shortened = await CliRun.RunAsync("verify", folder.PathOf("out"), "--against", drawing, "--target", "xps-spline");
        await File.WriteAllLinesAsync(folder.PathOf("out/traj0_path.txt"), ["0,0,0", "no number"]);
        var unreadable = await CliRun.RunAsync("verify", folder.PathOf("out"), "--against", drawing, "--target", "xps-spline");

        Assert.Equal((1, 1, 1), (moved.ExitCode, shortened.ExitCode, unreadable.ExitCode));
        Assert.Contains("VER0008", moved.Error, StringComparison.Ordinal);
        Assert.Contains("VER0009", shortened.Error, StringComparison.Ordinal);
        Assert.Contains("TRJ0003", unreadable.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_length_of_steps_alone_asks_for_equal_steps()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("circle.dxf", Circle);
        await CliRun.RunAsync("trajectory", drawing, "-o", folder.PathOf("a"), "--segment-length", "0.5");
        await CliRun.RunAsync("trajectory", drawing, "-o", folder.PathOf("b"), "--segment-length", "0.5", "--density", "uniform");

        Assert.Equal(126 + 3, (await File.ReadAllLinesAsync(folder.PathOf("a/traj0_path.txt"))).Length); // ceil(20 pi / 0.5) steps and the phantoms
        Assert.Equal(await File.ReadAllTextAsync(folder.PathOf("b/traj0_path.txt")), await File.ReadAllTextAsync(folder.PathOf("a/traj0_path.txt")));
    }

    [Fact]
    public async Task A_file_that_the_controller_would_not_take_is_written_only_when_asked_for()
    {
        using var folder = new TemporaryFolder();
        var profile = folder.WithFile("machine.json", "{ \"travelX\": { \"min\": 0, \"max\": 15 } }");
        var drawing = folder.WithFile("circle.dxf", Circle);
        var refused = await CliRun.RunAsync("trajectory", drawing, "-o", folder.PathOf("out"), "--format", "xps-spline", "--machine", profile);
        var isThere = Directory.Exists(folder.PathOf("out"));
        var accepted = await CliRun.RunAsync("trajectory", drawing, "-o", folder.PathOf("out"), "--format", "xps-spline", "--machine", profile, "--accept-errors");

        Assert.Equal((1, false, 1), (refused.ExitCode, isThere, accepted.ExitCode));
        Assert.Contains("TRJ0002", refused.Error, StringComparison.Ordinal);
        Assert.Contains("nothing was written", refused.Error, StringComparison.Ordinal);
        Assert.True(File.Exists(folder.PathOf("out/traj0_path.txt")));
    }

    [Fact]
    public async Task A_feed_that_the_axes_cannot_follow_is_told_with_the_speed_that_they_can()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("trajectory", folder.WithFile("circle.dxf", Circle), "-o", folder.PathOf("out"), "--format", "xps-spline", "--feed", "6000");

        Assert.Equal(0, run.ExitCode);
        Assert.Contains("TRJ0005", run.Error, StringComparison.Ordinal);
        Assert.Matches(@"Up to (4[89]|50)\.", run.Error); // sqrt(256 x 10) = 50.6 on the circle itself
    }

    /// <summary>A trajectory on a machine of lines and arcs: the motion is compared with the drawing, not with the spline.</summary>
    [Theory]
    [InlineData("paper-001", "stream")]
    [InlineData("gasket", "stream")]
    [InlineData("gasket", "calls")]
    public async Task A_trajectory_runs_and_stays_within_its_bound_and_the_counts(string drawing, string mode)
    {
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf(drawing), "--trajectory", "--connect", "sim:", "--mode", mode, "--max-error", "0.01", "--json");
        var report = JsonText.Of(run);
        var bound = report.GetProperty("trajectory").GetProperty("verifiedBound").GetDouble();

        Assert.Equal((0, "complete"), (run.ExitCode, report.GetProperty("outcome").GetString()));
        Assert.InRange(bound, 0.0005, 0.0103);
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, bound + 0.0025);
        Assert.Equal(0.0, report.GetProperty("missingLength").GetDouble());
        Assert.True(report.GetProperty("trajectory").GetProperty("points").GetInt32() > 10);
    }

    /// <summary>The trajectories of the sidecar are run instead of the drawing.</summary>
    [Fact]
    public async Task The_trajectories_beside_a_drawing_are_the_ones_that_run()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("circle.dxf", Circle);
        var made = await CliRun.RunAsync("script", folder.WithFile("a.scr", $"OPEN \"{drawing}\"\nSACEOFFSET ALL\n\n2 In\nQSAVE\n"));
        var run = await CliRun.RunAsync("run", drawing, "--trajectory", "--connect", "sim:", "--json", "--finish", "stay");
        var report = JsonText.Of(run);
        var end = double.Hypot((report.GetProperty("finalX").GetInt64() / 1000.0) - 100.0, (report.GetProperty("finalY").GetInt64() / 1000.0) - 50.0);

        Assert.Equal((0, 0), (made.ExitCode, run.ExitCode));
        Assert.InRange(end, 7.995, 8.005);
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, report.GetProperty("trajectory").GetProperty("verifiedBound").GetDouble() + 0.0025);
    }

    [Fact]
    public async Task A_damaged_file_beside_the_drawing_does_not_let_another_path_run()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("circle.dxf", Circle);
        folder.WithFile("circle.dxf.engraver.json", "{");
        var run = await CliRun.RunAsync("run", drawing, "--trajectory", "--connect", "sim:", "--json");

        Assert.Equal(1, run.ExitCode);
        Assert.Contains("SID0001", run.Error, StringComparison.Ordinal);
        Assert.Equal("refused", JsonText.Of(run).GetProperty("outcome").GetString());
    }

    /// <summary>The plug-in draws a CAD spline through the points instead (sace-xps-agie.md 1.2).</summary>
    [Fact]
    public async Task The_plot_shows_the_curve_that_is_run_with_points_and_corners()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("plot", SampleDrawing.PathOf("gasket"), "--what", "trajectory", "-o", folder.PathOf("a.svg"));
        var picture = await File.ReadAllTextAsync(folder.PathOf("a.svg"));

        Assert.Equal(0, run.ExitCode);
        Assert.Contains("class=\"cut heat15\"", picture, StringComparison.Ordinal);
        Assert.Contains("class=\"point\"", picture, StringComparison.Ordinal);
        Assert.Contains("(proven: 0.00", picture, StringComparison.Ordinal);
    }
}
