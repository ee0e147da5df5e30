using System.Text.Json;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Texts that are cut: every record of the job states their fonts, and a job whose fonts have changed is refused with their names.</summary>
public sealed class LetteredRunTests : IDisposable
{
    private const string Font = "plate-letters.ttf";

    private readonly TemporaryFolder _folder = new();
    private readonly string _drawing;

    public LetteredRunTests()
    {
        _drawing = _folder.PathOf("label.dxf");
        var sample = File.ReadAllText(SampleDrawing.PathOf("label-plate"));
        File.WriteAllText(_drawing, sample.Replace("[[csv:NAME]]", "Pump 1", StringComparison.Ordinal).Replace("[[n:0000]]", "0042", StringComparison.Ordinal).Replace("[[date:yyyy-MM-dd]]", "2026-11-27", StringComparison.Ordinal));
        File.Copy(Path.Combine(RepositoryFolder.Samples, Font), _folder.PathOf(Font));
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Every_record_states_the_fonts_and_the_texts_are_cut_as_lines_are()
    {
        var run = await CliRun.RunAsync("run", _drawing, "--connect", "sim:", "--cut", "text", "--json", "--journal", _folder.PathOf("a.jsonl"));
        var report = JsonText.Of(run);
        var plan = JsonText.Of(await CliRun.RunAsync("plan", _drawing, "--cut", "text", "--json"));
        var certificate = JsonText.Of(await CliRun.RunAsync("certify", _drawing, "--cut", "text", "--json"));
        var without = JsonText.Of(await CliRun.RunAsync("plan", _drawing, "--json"));

        Assert.Equal((0, "complete", 0.0), (run.ExitCode, report.GetProperty("outcome").GetString(), report.GetProperty("missingLength").GetDouble()));
        Assert.InRange(report.GetProperty("maxDeviation").GetDouble(), 0.0, report.GetProperty("tolerance").GetDouble());
        Assert.DoesNotContain("SEQ0003", run.Error, StringComparison.Ordinal);
        Assert.Equal([(Font, "Plate Letters"), ("txt", "Engraver")], Fonts(report).Select(font => (font.Requested, font.Font)));
        Assert.Equal((true, true), (Fonts(report).SequenceEqual(Fonts(plan)), Fonts(report).SequenceEqual(Fonts(certificate))));
        Assert.Empty(Fonts(without));
        Assert.Contains(Fonts(report)[0].Sha256, (await File.ReadAllLinesAsync(_folder.PathOf("a.jsonl")))[1], StringComparison.Ordinal);
        Assert.Empty(report.GetProperty("notCut").EnumerateObject());
    }

    [Fact]
    public async Task A_changed_font_makes_the_certificate_stale_and_verify_names_it()
    {
        var program = _folder.PathOf("label.dmc");
        Assert.Equal(0, (await CliRun.RunAsync("post", _drawing, "--target", "galil", "--cut", "text", "-o", program)).ExitCode);
        Assert.Equal(0, (await CliRun.RunAsync("certify", _drawing, "--cut", "text", "--program", program)).ExitCode);
        string[] verify = ["verify", program, "--against", _drawing, "--cut", "text"];
        string[] check = ["certify", _drawing, "--cut", "text", "--program", program, "--check"];
        var valid = await CliRun.RunAsync(verify);
        var stands = await CliRun.RunAsync(check);
        await ChangeFontAsync();
        var changed = await CliRun.RunAsync(verify);
        var stale = await CliRun.RunAsync(check);

        Assert.Equal((0, 0), (valid.ExitCode, stands.ExitCode));
        Assert.Equal((1, 1), (changed.ExitCode, stale.ExitCode));
        Assert.Contains($"VER0024: The fonts {Font} are not those with which the certificate label.certificate.json was issued.", changed.Error, StringComparison.Ordinal);
        Assert.Contains($"changed: the fonts {Font};", stale.Out, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_job_whose_font_has_changed_is_not_resumed()
    {
        var journal = _folder.PathOf("a.jsonl");
        string[] run = ["run", _drawing, "--connect", "sim:", "--cut", "text", "--json"];
        var stopped = await ResumeRunTests.StoppedAsync(60, [.. run, "--journal", journal]);
        await ChangeFontAsync();
        var refused = await CliRun.RunAsync([.. run, "--resume", journal]);

        Assert.Equal((5, 2), (stopped.ExitCode, refused.ExitCode));
        Assert.Matches($"JOB0040.*the font {Font} was Plate Letters .exact, SHA-256 [0-9a-f]{{64}}., now Plate Letters .exact, SHA-256 [0-9a-f]{{64}}.", refused.Error);
    }

    /// <summary>A byte behind the tables: the font is read as before.</summary>
    private async Task ChangeFontAsync()
    {
        var bytes = await File.ReadAllBytesAsync(_folder.PathOf(Font));
        File.Delete(_folder.PathOf(Font));
        await File.WriteAllBytesAsync(_folder.PathOf(Font), [.. bytes, 0]);
    }

    private static List<(string Requested, string Font, string Match, string Sha256)> Fonts(JsonElement report) =>
        [.. report.GetProperty("fonts").EnumerateArray().Select(font => (font.GetProperty("requested").GetString()!, font.GetProperty("font").GetString()!, font.GetProperty("match").GetString()!, font.GetProperty("sha256").GetString()!))];
}
