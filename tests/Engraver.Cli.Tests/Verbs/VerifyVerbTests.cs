namespace Engraver.Cli.Tests.Verbs;

public class VerifyVerbTests
{
    [Theory]
    [InlineData("galil")]
    [InlineData("galil-calls")]
    public async Task What_post_writes_verify_finds_ok(string target)
    {
        using var folder = new TemporaryFolder();
        await CliRun.RunAsync("post", SampleDrawing.PathOf("nameplate"), "--target", target, "--start", "5,5", "-o", folder.PathOf("job.dmc"));
        var run = await CliRun.RunAsync("verify", folder.PathOf("job.dmc"), "--against", SampleDrawing.PathOf("nameplate"), "--start", "5,5", "--json");
        var report = JsonText.Of(run);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal(["maxDeviation", "tolerance", "missingLength", "extraLength", "ok", "minFeed", "maxFeed", "lowestZ", "blend", "target", "cornerDeviation"], report.EnumerateObject().Select(field => field.Name));
        Assert.True(report.GetProperty("ok").GetBoolean());
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, report.GetProperty("tolerance").GetDouble());
    }

    /// <summary>Regression found by random tests: an arithmetic overflow and a crash report.</summary>
    [Theory]
    [InlineData("1e15,0", "MOT0003")]
    [InlineData("1e9,0", "VER0009")]
    public async Task A_start_that_no_controller_counts_is_told_and_nothing_of_the_drawing_is_cut(string start, string id)
    {
        using var folder = new TemporaryFolder();
        await CliRun.RunAsync("post", SampleDrawing.PathOf("nameplate"), "--target", "galil", "-o", folder.PathOf("job.dmc"));

        var run = await CliRun.RunAsync("verify", folder.PathOf("job.dmc"), "--against", SampleDrawing.PathOf("nameplate"), "--start", start, "--json");

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Contains(id, run.Error, StringComparison.Ordinal);
        Assert.False(JsonText.Of(run).GetProperty("ok").GetBoolean());
        Assert.True(JsonText.Of(run).GetProperty("missingLength").GetDouble() > 100.0); // No part of it is cut.
    }

    [Theory]
    [InlineData("galil", "40,-12.5")]
    [InlineData("galil-calls", "-200.25,3")]
    public async Task A_program_with_an_origin_of_its_own_is_judged_by_that_place_and_by_no_other(string target, string origin)
    {
        using var folder = new TemporaryFolder();
        string[] read = ["verify", folder.PathOf("job.dmc"), "--against", SampleDrawing.PathOf("nameplate"), "--target", target, "--start", "5,5", "--json"];
        await CliRun.RunAsync("post", SampleDrawing.PathOf("nameplate"), "--target", target, "--start", "5,5", $"--origin={origin}", "-o", folder.PathOf("job.dmc"));

        var told = await CliRun.RunAsync([.. read, $"--origin={origin}"]);
        var beside = await CliRun.RunAsync([.. read, "--origin=40,-12"]);
        var untold = await CliRun.RunAsync(read);

        Assert.Equal((ExitCode.Done, ExitCode.DrawingError, ExitCode.DrawingError), (told.ExitCode, beside.ExitCode, untold.ExitCode));
        Assert.InRange(JsonText.Of(told).GetProperty("maxDeviation").GetDouble(), 0.0, JsonText.Of(told).GetProperty("tolerance").GetDouble());
    }

    [Fact]
    public async Task A_program_that_goes_to_its_place_by_itself_is_certified_for_the_place_that_is_given()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.PathOf("part.dxf");
        File.Copy(SampleDrawing.PathOf("paper-001"), drawing);
        await CliRun.RunAsync("post", drawing, "--target", "galil", "--origin=40,-12.5", "-o", folder.PathOf("job.dmc"));
        string[] certify = ["certify", drawing, "--target", "galil", "--program", folder.PathOf("job.dmc"), "-o", folder.PathOf("job.json")];

        Assert.Equal(ExitCode.DrawingError, (await CliRun.RunAsync(certify)).ExitCode);
        Assert.Equal(ExitCode.DrawingError, (await CliRun.RunAsync([.. certify, "--origin=40,-12"])).ExitCode);
        Assert.False(File.Exists(folder.PathOf("job.json")));
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync([.. certify, "--origin=40,-12.5"])).ExitCode);
        Assert.True(File.Exists(folder.PathOf("job.json")));
        Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync("certify", drawing, "--target", "galil", "--origin=40,-12.5")).ExitCode);
    }

    [Theory]
    [InlineData("gcode", "1,2")]
    [InlineData("galil", "work")]
    [InlineData("galil", "1")]
    [InlineData("sace", "1,2")]
    public async Task An_origin_is_a_place_of_a_target_that_has_one(string target, string origin)
    {
        var run = await CliRun.RunAsync("verify", "job.dmc", "--against", SampleDrawing.PathOf("paper-001"), "--target", target, "--origin", origin);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("--origin", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("gcode", "0.05", "0.05", ExitCode.Done)]
    [InlineData("gcode", "0.05", "0", ExitCode.DrawingError)]
    [InlineData("gcode", "0.05", "2", ExitCode.Usage)]
    [InlineData("galil", null, "0.05", ExitCode.Usage)]
    public async Task Rounded_corners_are_allowed_where_they_were_asked_for(string target, string? written, string allowed, int exit)
    {
        using var folder = new TemporaryFolder();
        await CliRun.RunAsync(["post", SampleDrawing.PathOf("paper-001"), "--target", target, "-o", folder.PathOf("job.txt"), .. written is null ? (string[])[] : ["--blend", written]]);
        var run = await CliRun.RunAsync("verify", folder.PathOf("job.txt"), "--against", SampleDrawing.PathOf("paper-001"), "--target", target, "--blend", allowed, "--json");

        Assert.Equal(exit, run.ExitCode);
        if (exit != ExitCode.Usage) Assert.Equal(0.1, JsonText.Of(run).GetProperty("blend").GetDouble());
    }

    [Theory]
    [InlineData("gcode", "linuxcnc", 0)] // reads grbl's program too
    [InlineData("gcode", "grbl", 0)]
    [InlineData("xps-linearc", null, 0)]
    [InlineData("galil", "grbl", 2)]
    public async Task A_dialect_is_read_by_its_own_rules_and_for_a_target_that_has_one(string target, string? dialect, int exit)
    {
        using var folder = new TemporaryFolder();
        string[] written = target == "gcode" ? ["--dialect", "grbl"] : [];
        await CliRun.RunAsync(["post", SampleDrawing.PathOf("paper-001"), "--target", target, "-o", folder.PathOf("job.txt"), .. written]);
        var run = await CliRun.RunAsync(["verify", folder.PathOf("job.txt"), "--against", SampleDrawing.PathOf("paper-001"), "--target", target, "--json", .. dialect is null ? (string[])[] : ["--dialect", dialect]]);

        Assert.Equal(exit, run.ExitCode);
        if (exit == 0 && target == "gcode") Assert.Equal(1200.0, JsonText.Of(run).GetProperty("maxFeed").GetDouble());
    }

    [Fact]
    public async Task LinuxCNCs_marks_are_no_program_of_grbl()
    {
        using var folder = new TemporaryFolder();
        await CliRun.RunAsync("post", SampleDrawing.PathOf("paper-001"), "--target", "gcode", "-o", folder.PathOf("job.ngc"));
        var run = await CliRun.RunAsync("verify", folder.PathOf("job.ngc"), "--against", SampleDrawing.PathOf("paper-001"), "--target", "gcode", "--dialect", "grbl");

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Contains("job.ngc(1): error PST0001", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Another_layer_selection_than_that_of_the_post_is_exit_1_and_says_what_is_missing()
    {
        using var folder = new TemporaryFolder();
        await CliRun.RunAsync("post", SampleDrawing.PathOf("nameplate"), "--target", "galil", "--skip-layers", "Rahmen", "-o", folder.PathOf("job.dmc"));
        var run = await CliRun.RunAsync("verify", folder.PathOf("job.dmc"), "--against", SampleDrawing.PathOf("nameplate"), "--target", "galil");

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.StartsWith("NOT OK: ", run.Out, StringComparison.Ordinal);
        Assert.Contains("error VER0009", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("", "VER0001")]
    [InlineData("G0 X1\n", "PST0001")] // G-code by how it begins, whatever its name
    [InlineData("MG 1\n", "VER0002")]
    [InlineData("#JOB\nJP#JOB\n", "VER0007")]
    public async Task A_file_that_is_no_program_is_exit_1_with_one_sentence_and_the_object(string text, string id)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("verify", folder.WithFile("job.dmc", text), "--against", SampleDrawing.PathOf("paper-001"), "--json");

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.False(JsonText.Of(run).GetProperty("ok").GetBoolean());
        Assert.Contains($": error {id}", Assert.Single(run.Error.TrimEnd().Split('\n')), StringComparison.Ordinal);
    }

    /// <summary>Regression: G-code without --target was reported to lack #JOB.</summary>
    [Fact]
    public async Task Without_a_target_the_file_itself_says_in_which_form_it_is_and_otherwise_it_is_told_what_was_tried()
    {
        using var folder = new TemporaryFolder();
        await CliRun.RunAsync("post", SampleDrawing.PathOf("paper-001"), "--target", "gcode", "--dialect", "grbl", "-o", folder.PathOf("job.txt"));
        var known = await CliRun.RunAsync("verify", folder.PathOf("job.txt"), "--against", SampleDrawing.PathOf("paper-001"), "--blend", "0", "--json");
        var unknown = await CliRun.RunAsync("verify", folder.WithFile("words.txt", "hello\n"), "--against", SampleDrawing.PathOf("paper-001"));

        Assert.Equal((ExitCode.Done, "gcode"), (known.ExitCode, JsonText.Of(known).GetProperty("target").GetString()));
        Assert.Equal(ExitCode.DrawingError, unknown.ExitCode);
        Assert.Contains("was not detected; it is read as galil", unknown.Error, StringComparison.Ordinal);
    }

    /// <summary>The post options must be given to the verification; otherwise the program does not match the job.</summary>
    [Fact]
    public async Task A_program_in_another_frame_is_ok_only_where_the_frame_is_named()
    {
        using var folder = new TemporaryFolder();
        await CliRun.RunAsync("post", SampleDrawing.PathOf("paper-001"), "--target", "gcode", "--work-offset", "G55", "-o", folder.PathOf("job.ngc"));
        string[] verify = ["verify", folder.PathOf("job.ngc"), "--against", SampleDrawing.PathOf("paper-001")];
        var unsaid = await CliRun.RunAsync(verify);
        var said = await CliRun.RunAsync([.. verify, "--work-offset", "G55"]);
        var wrong = await CliRun.RunAsync([.. verify, "--pen", "2"]);

        Assert.Equal((ExitCode.DrawingError, ExitCode.Done, ExitCode.Usage), (unsaid.ExitCode, said.ExitCode, wrong.ExitCode));
        Assert.Contains("VER0013: The program has G55 in line", unsaid.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_missing_program_and_a_missing_drawing_are_each_named()
    {
        using var folder = new TemporaryFolder();
        var program = await CliRun.RunAsync("verify", folder.PathOf("nowhere.dmc"), "--against", SampleDrawing.PathOf("paper-001"));
        var drawing = await CliRun.RunAsync("verify", folder.WithFile("job.dmc", "#JOB\nEN\n"), "--against", folder.PathOf("nowhere.dxf"), "--json");

        Assert.Equal((ExitCode.DrawingError, ExitCode.DrawingError), (program.ExitCode, drawing.ExitCode));
        Assert.Contains("nowhere.dmc: error DOC0001", program.Error, StringComparison.Ordinal);
        Assert.Contains("nowhere.dxf: error DOC0001", drawing.Error, StringComparison.Ordinal);
        Assert.False(JsonText.Of(drawing).GetProperty("ok").GetBoolean());
    }

    [Theory]
    [InlineData("verify")]
    [InlineData("verify", "job.dmc")]
    [InlineData("verify", "job.dmc", "--against", "drawing.dxf", "--target", "punched-tape")]
    public async Task What_is_not_built_or_not_given_is_a_usage_error(params string[] words) => Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync(words)).ExitCode);
}
