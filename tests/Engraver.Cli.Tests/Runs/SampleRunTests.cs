using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>The main job on every sample in every mode, judged by every motor sample of the simulated controller.</summary>
public class SampleRunTests
{
    /// <summary>2.5 counts at 1000 counts/mm and the default curve tolerance, millimetres.</summary>
    private const double AllowedDeviation = 0.0025 + 0.001;

    /// <summary>An ellipse, an elliptical arc, a cubic spline, a circle in an unequally scaled block.</summary>
    private const string CurvesDrawing = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n0\nCIRCLE\n10\n0\n20\n0\n40\n2\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
        + "0\nELLIPSE\n10\n0\n20\n0\n11\n8\n21\n2\n40\n0.4\n0\nELLIPSE\n10\n30\n20\n0\n11\n3\n21\n0\n40\n0.5\n41\n0.5\n42\n4\n"
        + "0\nSPLINE\n71\n3\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n40\n1\n10\n0\n20\n10\n10\n9\n20\n20\n10\n11\n20\n0\n10\n20\n20\n12\n"
        + "0\nINSERT\n2\nB\n10\n15\n20\n-15\n41\n2\n50\n30\n0\nENDSEC\n0\nEOF\n";

    public static TheoryData<string, string> Runs
    {
        get
        {
            var runs = new TheoryData<string, string>();
            foreach (var name in SampleDrawing.Names)
            {
                runs.Add(name, "stream");
                runs.Add(name, "calls");
                runs.Add(name, "program");
            }

            return runs;
        }
    }

    [Theory]
    [MemberData(nameof(Runs))]
    public async Task Every_cutting_sample_is_on_the_drawing_and_nothing_of_it_is_missing(string name, string mode)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf(name), "--connect", "sim:", "--mode", mode, "--json", "--journal", folder.PathOf("run.jsonl"));
        var report = JsonText.Of(run);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal("complete", report.GetProperty("outcome").GetString());
        Assert.Equal("record", report.GetProperty("deviationSource").GetString());
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, AllowedDeviation);
        Assert.Equal(0.0, report.GetProperty("missingLength").GetDouble());
        Assert.Equal(report.GetProperty("segmentsSent").GetInt32(), report.GetProperty("segmentsExecuted").GetInt32());
        Assert.Equal((0, 0), (report.GetProperty("underruns").GetInt32(), report.GetProperty("rejected").GetInt32()));
    }

    [Theory]
    [InlineData("stream")]
    [InlineData("calls")]
    public async Task Ellipses_and_splines_are_cut_within_the_curve_tolerance_of_the_exact_curves(string mode)
    {
        using var folder = new TemporaryFolder();
        var file = folder.WithFile("curves.dxf", CurvesDrawing);
        var report = JsonText.Of(await CliRun.RunAsync("run", file, "--connect", "sim:", "--mode", mode, "--json", "--journal", folder.PathOf("run.jsonl")));

        Assert.Equal("complete", report.GetProperty("outcome").GetString());
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, AllowedDeviation);
        Assert.Equal(0.0, report.GetProperty("missingLength").GetDouble());
        Assert.Equal((0, 0), (report.GetProperty("underruns").GetInt32(), report.GetProperty("rejected").GetInt32()));
    }

    [Fact]
    public async Task The_last_line_says_how_far_the_motors_were_off_and_that_nothing_is_missing()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--journal", folder.PathOf("run.jsonl"));

        Assert.Matches(@"^complete: 6 of 6 segments cut in [0-9.]+ s of machine time; maximum deviation of the simulated motors 0\.00[0-9]+ mm; at rounded corners 0\.00[0-9]+ mm; the whole drawing was cut\.\n$", run.Out);
    }

    [Fact]
    public async Task The_object_has_every_field_of_the_contract()
    {
        using var folder = new TemporaryFolder();
        var report = JsonText.Of(await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--json", "--journal", folder.PathOf("run.jsonl")));

        Assert.Equal(
            ["outcome", "segmentsSent", "segmentsExecuted", "seconds", "plannedSeconds", "underruns", "rejected", "finalX", "finalY", "countsPerMillimetre", "maxDeviation", "cornerDeviation", "missingLength", "lag", "deviationSource", "journal", "leftOut", "notCut", "origin", "finalZ", "holds", "resumedFrom", "checks", "openLoop", "maxFollowingError", "tolerance", "fonts", "trajectory", "plate", "plates"],
            report.EnumerateObject().Select(field => field.Name));
        Assert.Equal(System.Text.Json.JsonValueKind.Null, report.GetProperty("finalZ").ValueKind); // a machine without a Z axis
        Assert.Equal(System.Text.Json.JsonValueKind.Null, report.GetProperty("trajectory").ValueKind); // the drawing itself was run
        Assert.Equal((0, 0), (report.GetProperty("finalX").GetInt32(), report.GetProperty("finalY").GetInt32())); // After the return to the drawing's start.
        Assert.Equal("""{"x":0,"y":0,"source":"work"}""", System.Text.Json.JsonSerializer.Serialize(report.GetProperty("origin")));
        Assert.True(File.Exists(folder.PathOf("run.jsonl")));
    }

    [Fact]
    public async Task The_start_option_is_where_the_job_begins_and_ends_and_with_origin_here_where_the_machine_stands()
    {
        using var folder = new TemporaryFolder();
        var report = JsonText.Of(await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--json", "--start", "50,50", "--journal", folder.PathOf("run.jsonl")));

        Assert.Equal((50000, 50000), (report.GetProperty("finalX").GetInt32(), report.GetProperty("finalY").GetInt32()));
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, AllowedDeviation);
        Assert.Equal(0.0, report.GetProperty("missingLength").GetDouble());
        var here = JsonText.Of(await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--json", "--start", "50,50", "--origin", "here", "--journal", folder.PathOf("here.jsonl")));
        Assert.Equal((0, 0), (here.GetProperty("finalX").GetInt32(), here.GetProperty("finalY").GetInt32()));
        Assert.Equal("""{"x":-50,"y":-50,"source":"here"}""", System.Text.Json.JsonSerializer.Serialize(here.GetProperty("origin")));
        Assert.Equal(0.0, here.GetProperty("missingLength").GetDouble());
    }

    /// <summary>A part with map coordinates: its counts exceed 32 bits, those relative to the machine do not.</summary>
    [Theory]
    [InlineData("stream")]
    [InlineData("calls")]
    [InlineData("program")]
    public async Task A_drawing_far_from_its_zero_runs_from_where_the_machine_stands(string mode)
    {
        using var folder = new TemporaryFolder();
        (int, object)[] Line(double x1, double y1, double x2, double y2) => [(0, "LINE"), (8, "0"), (10, 3_500_000 + x1), (20, 5_400_000 + y1), (11, 3_500_000 + x2), (21, 5_400_000 + y2)];
        File.WriteAllBytes(folder.PathOf("map.dxf"), DxfText.WithEntities([.. Line(0, 0, 6, 0), .. Line(6, 0, 6, 4), .. Line(6, 4, 0, 4), .. Line(0, 4, 0, 0)]).ToAscii());
        string[] run = ["run", folder.PathOf("map.dxf"), "--connect", "sim:", "--json", "--start", "3500000,5400000", "--mode", mode, "--journal", folder.PathOf("run.jsonl")];

        var report = JsonText.Of(await CliRun.RunAsync([.. run, "--origin", "here"]));
        Assert.Equal(("complete", 0.0), (report.GetProperty("outcome").GetString(), report.GetProperty("missingLength").GetDouble()));
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, AllowedDeviation);
        Assert.Equal((0, 0), (report.GetProperty("finalX").GetInt32(), report.GetProperty("finalY").GetInt32()));

        Assert.Equal(ExitCode.Refused, (await CliRun.RunAsync([.. run, "--origin", "work"])).ExitCode); // At the controller's zero.
    }

    [Theory]
    [InlineData("--origin", "there")]
    [InlineData("--origin", "1,x")]
    [InlineData("--finish", "home")]
    [InlineData("--finish", "park")] // the default profile has no such place
    public async Task A_place_that_is_none_is_a_usage_error(string option, string value)
    {
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", option, value);

        Assert.Equal((ExitCode.Usage, ""), (run.ExitCode, run.Out));
        Assert.Contains(option, run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_drawing_with_errors_does_not_start_without_consent()
    {
        using var folder = new TemporaryFolder();
        var file = folder.WithFile("cut.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n3\n21\n4\n0\nLINE\n8\n0\n10\n0\n");
        var refused = await CliRun.RunAsync("run", file, "--connect", "sim:", "--json", "--journal", folder.PathOf("a.jsonl"));
        var accepted = await CliRun.RunAsync("run", file, "--connect", "sim:", "--json", "--accept-errors", "--journal", folder.PathOf("b.jsonl"));

        Assert.Equal((ExitCode.DrawingError, "refused", 0), (refused.ExitCode, JsonText.Of(refused).GetProperty("outcome").GetString(), JsonText.Of(refused).GetProperty("segmentsSent").GetInt32()));
        Assert.Equal((ExitCode.DrawingError, "complete", 1), (accepted.ExitCode, JsonText.Of(accepted).GetProperty("outcome").GetString(), JsonText.Of(accepted).GetProperty("segmentsExecuted").GetInt32()));
    }

    [Fact]
    public async Task What_an_accepted_error_leaves_out_is_counted_and_said()
    {
        using var folder = new TemporaryFolder();
        var file = folder.WithFile("odd.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n3\n21\n4\n0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\nx\n0\nENDSEC\n0\nEOF\n");
        var json = await CliRun.RunAsync("run", file, "--connect", "sim:", "--json", "--accept-errors", "--journal", folder.PathOf("a.jsonl"));
        var told = await CliRun.RunAsync("run", file, "--connect", "sim:", "--accept-errors", "--journal", folder.PathOf("b.jsonl"));
        var leftOut = JsonText.Of(json).GetProperty("leftOut");

        Assert.Equal((1, System.Text.Json.JsonValueKind.Null), (leftOut.GetProperty("count").GetInt32(), leftOut.GetProperty("length").ValueKind));
        Assert.Equal((ExitCode.DrawingError, ExitCode.DrawingError), (json.ExitCode, told.ExitCode));
        Assert.Contains("1 entity could not be read and was LEFT OUT", told.Out, StringComparison.Ordinal);
        Assert.DoesNotContain("the whole drawing was cut", told.Out, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_dry_run_moves_with_the_tool_off()
    {
        using var folder = new TemporaryFolder();
        var report = JsonText.Of(await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--dry-run", "--json", "--journal", folder.PathOf("a.jsonl")));

        Assert.Equal("complete", report.GetProperty("outcome").GetString());
        Assert.Equal("none", report.GetProperty("deviationSource").GetString());
    }
}
