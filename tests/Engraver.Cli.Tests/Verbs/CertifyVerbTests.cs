using Engraver.TestKit;

namespace Engraver.Cli.Tests.Verbs;

public class CertifyVerbTests
{
    [Fact]
    public async Task The_object_is_the_file_and_has_every_field()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("part.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001")));
        var run = await CliRun.RunAsync("certify", drawing, "--json");
        var made = JsonText.Of(run);

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        Assert.Equal(run.Out, await File.ReadAllTextAsync(folder.PathOf("part.certificate.json")));
        Assert.Equal(
            ["version", "issued", "issuedBy", "drawing", "program", "settings", "profile", "ok", "maxDeviation", "cornerDeviation", "tolerance", "missingLength", "extraLength", "limits", "plannedSeconds", "findings", "fonts"],
            made.EnumerateObject().Select(field => field.Name));
        Assert.Equal(["minX", "minY", "maxX", "maxY", "travelX", "travelY", "fits", "minZ", "maxZ", "travelZ"], made.GetProperty("limits").EnumerateObject().Select(field => field.Name));
        Assert.Equal(JsonText.Of(await CliRun.RunAsync("plan", drawing, "--json")).GetProperty("seconds").GetProperty("total").GetDouble(), made.GetProperty("plannedSeconds").GetDouble());
        var verified = await CliRun.RunAsync("verify", Path.Combine(RepositoryFolder.Samples, "expected", "paper-001.galil.dmc"), "--against", drawing, "--json");
        Assert.Equal(JsonText.Of(verified).GetProperty("maxDeviation").GetDouble(), made.GetProperty("maxDeviation").GetDouble());
    }

    [Fact]
    public async Task A_run_shows_whether_it_stands_and_the_check_says_what_differs()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("part.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001")));
        string[] run = ["run", drawing, "--connect", "sim:", "--journal", folder.PathOf("a.jsonl")];
        var before = await CliRun.RunAsync(run);
        var none = await CliRun.RunAsync("certify", drawing, "--check", "--json");
        await CliRun.RunAsync("certify", drawing);
        var stands = await CliRun.RunAsync(run);
        var held = await CliRun.RunAsync("certify", drawing, "--check");
        var stale = await CliRun.RunAsync([.. run, "--feed", "700"]);
        var differs = await CliRun.RunAsync("certify", drawing, "--check", "--json", "--feed", "700", "--max-error", "0.002");

        Assert.Contains("note   The drawing has no certificate; engraver certify verifies the program and writes one.", before.Error.Split('\n'));
        Assert.Contains(stands.Error.Split('\n'), line => line.StartsWith("ok     The certificate is valid:", StringComparison.Ordinal));
        Assert.Contains("WARN   The certificate beside the drawing is for another job; changed: the machine profile; engraver certify writes a new one.", stale.Error.Split('\n'));
        Assert.All([before, stands, stale], job => Assert.Equal(ExitCode.Done, job.ExitCode));
        Assert.Equal((ExitCode.DrawingError, "none"), (none.ExitCode, JsonText.Of(none).GetProperty("standing").GetString()));
        Assert.Equal(ExitCode.Done, held.ExitCode);
        Assert.Equal((ExitCode.DrawingError, "stale", "max-error profile"), (differs.ExitCode, JsonText.Of(differs).GetProperty("standing").GetString(), string.Join(' ', JsonText.Of(differs).GetProperty("differs").EnumerateArray().Select(part => part.GetString()))));
        Assert.Equal(["standing", "file", "differs", "problem"], JsonText.Of(none).EnumerateObject().Select(field => field.Name));
    }

    [Fact]
    public async Task Another_target_and_another_dialect_have_their_own_files_and_stand_on_the_page_of_the_job()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("part.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001")));
        var agie = await CliRun.RunAsync("certify", drawing, "--target", "agie");
        var grbl = JsonText.Of(await CliRun.RunAsync("certify", drawing, "--target", "gcode", "--dialect", "grbl", "--json"));
        var usual = JsonText.Of(await CliRun.RunAsync("certify", drawing, "--target", "gcode", "--dialect", "linuxcnc", "--json"));
        var none = await CliRun.RunAsync("certify", drawing, "--target", "agie", "--dialect", "grbl");
        await CliRun.RunAsync("report", drawing, "-o", folder.PathOf("a.html"));
        var page = await File.ReadAllTextAsync(folder.PathOf("a.html"));

        Assert.Equal((ExitCode.Done, ExitCode.Usage), (agie.ExitCode, none.ExitCode));
        Assert.Equal(["part.agie.certificate.json", "part.gcode-grbl.certificate.json", "part.gcode.certificate.json"], Directory.GetFiles(folder.PathOf(""), "part.*.certificate.json").Select(Path.GetFileName).Order(StringComparer.Ordinal));
        Assert.Equal(("grbl", null), (grbl.GetProperty("program").GetProperty("dialect").GetString(), usual.GetProperty("program").GetProperty("dialect").GetString()));
        foreach (var target in new[] { "agie", "gcode", "gcode grbl" }) Assert.Matches($"<td class=\"mark\">{target}</td>\\s*<td>valid</td>", page);
        Assert.Contains(grbl.GetProperty("program").GetProperty("sha256").GetString()!, page, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("galil-calls")]
    [InlineData("agie")]
    public async Task A_posted_file_is_certified_as_it_is_and_a_changed_byte_of_it_is_noticed(string target)
    {
        using var folder = new TemporaryFolder();
        var (program, out_) = (folder.PathOf("job.txt"), folder.PathOf("c.json"));
        await CliRun.RunAsync("post", SampleDrawing.PathOf("paper-001"), "--target", target, "-o", program);
        string[] words = ["certify", SampleDrawing.PathOf("paper-001"), "--target", target, "--program", program, "-o", out_];
        var made = await CliRun.RunAsync(words);
        var stands = await CliRun.RunAsync([.. words, "--check"]);
        await File.AppendAllTextAsync(program, "\n");
        var stale = await CliRun.RunAsync([.. words, "--check", "--json"]);

        Assert.Equal((ExitCode.Done, ExitCode.Done, ExitCode.DrawingError), (made.ExitCode, stands.ExitCode, stale.ExitCode));
        Assert.Equal("program", Assert.Single(JsonText.Of(stale).GetProperty("differs").EnumerateArray()).GetString());
    }

    /// <summary>A pipe cannot be read again, so the certificate could not be checked later.</summary>
    [Fact]
    public async Task A_drawing_that_is_no_file_gets_none()
    {
        if (!OperatingSystem.IsLinux()) return;
        using var folder = new TemporaryFolder();
        var pipe = NamedPipe.Make(folder.PathOf("part.dxf"));
        var writing = Task.Run(async () =>
        {
            await using var end = await NamedPipe.WriterAsync(pipe);
            await end.WriteAsync(await File.ReadAllBytesAsync(SampleDrawing.PathOf("paper-001")));
        });
        var run = await CliRun.RunAsync("certify", pipe, "-o", folder.PathOf("c.json"));
        await writing;

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("cannot be read a second time", run.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(folder.PathOf("c.json")));
    }

    [Fact]
    public async Task Nothing_is_written_for_a_program_that_is_not_the_drawing_nor_for_a_drawing_without_one()
    {
        using var folder = new TemporaryFolder();
        var wrong = await CliRun.RunAsync("certify", SampleDrawing.PathOf("paper-001"), "--program", Path.Combine(RepositoryFolder.Samples, "expected", "gasket.galil.dmc"), "-o", folder.PathOf("c.json"), "--json");
        var missing = await CliRun.RunAsync("certify", SampleDrawing.PathOf("paper-001"), "--program", folder.PathOf("nowhere"), "-o", folder.PathOf("c.json"));
        var empty = await CliRun.RunAsync("certify", folder.PathOf("nowhere.dxf"));

        Assert.Equal((ExitCode.DrawingError, ExitCode.Usage, ExitCode.DrawingError), (wrong.ExitCode, missing.ExitCode, empty.ExitCode));
        Assert.False(JsonText.Of(wrong).GetProperty("ok").GetBoolean());
        Assert.Contains("error VER", wrong.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(folder.PathOf("c.json")));
        Assert.Contains("not certified", empty.Error, StringComparison.Ordinal);
    }
}
