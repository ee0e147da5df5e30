using Engraver.TestKit;

namespace Engraver.Cli.Tests.Verbs;

public class ProfileVerbTests
{
    [Theory]
    [InlineData("machine-default.json", "The profile states no costs.")]
    [InlineData("machine-mill.json", "Z moves the tool up and down: rapids are 4 mm above the work")]
    [InlineData("machine-laser.json", "one count is 0.0125 mm")]
    [InlineData("machine-eroder.json", "one count is 0.000635 mm (0.000025 inch)")]
    public async Task Every_example_is_checked_without_a_finding_and_explained(string name, string says)
    {
        var check = await CliRun.RunAsync("profile", "check", Path.Combine(RepositoryFolder.Samples, name));

        Assert.Equal((ExitCode.Done, ""), (check.ExitCode, check.Error));
        Assert.Contains(says, check.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("machine-mill.json")]
    [InlineData("machine-laser.json")]
    [InlineData("machine-eroder.json")]
    public async Task Every_example_cuts_the_drawing_of_the_paper(string name)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--machine", Path.Combine(RepositoryFolder.Samples, name), "--json", "--journal", folder.PathOf("run.jsonl"));
        var told = JsonText.Of(run);

        Assert.Equal((ExitCode.Done, "complete", 0.0), (run.ExitCode, told.GetProperty("outcome").GetString(), told.GetProperty("missingLength").GetDouble()));
        Assert.InRange(told.GetProperty("maxDeviation").GetDouble(), 0.0, 0.02);
    }

    [Fact]
    public async Task What_is_wrong_is_told_with_its_line_and_the_nearest_name_and_ends_with_1()
    {
        using var folder = new TemporaryFolder();
        File.WriteAllText(folder.PathOf("bad.json"), "{\n \"feedMmPerMinut\": 600,\n \"rapids\": 3000\n}");
        var check = await CliRun.RunAsync("profile", "check", folder.PathOf("bad.json"));
        var json = JsonText.Of(await CliRun.RunAsync("profile", "check", folder.PathOf("bad.json"), "--json"));

        Assert.Equal((ExitCode.DrawingError, ""), (check.ExitCode, check.Out));
        Assert.Contains("bad.json(2): error MOT0009: The machine profile has the unknown field feedMmPerMinut; the nearest known name is feedMmPerMinute.", check.Error, StringComparison.Ordinal);
        Assert.Contains("bad.json(3): error MOT0009", check.Error, StringComparison.Ordinal);
        Assert.Equal(["file", "ok", "findings", "meaning"], json.EnumerateObject().Select(field => field.Name));
        Assert.False(json.GetProperty("ok").GetBoolean());
        Assert.Equal([2, 3], json.GetProperty("findings").EnumerateArray().Select(finding => finding.GetProperty("line").GetInt32()));
        Assert.Equal(0, json.GetProperty("meaning").GetArrayLength());
        Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync("profile", "check", folder.PathOf("none.json"))).ExitCode);
    }

    [Fact]
    public async Task A_contradiction_is_warned_of_once_wherever_the_profile_is_loaded()
    {
        using var folder = new TemporaryFolder();
        File.WriteAllText(folder.PathOf("slow.json"), "{\n \"rapidMmPerMinute\": 600 }");
        var check = await CliRun.RunAsync("profile", "check", folder.PathOf("slow.json"));
        var plan = await CliRun.RunAsync("plan", SampleDrawing.PathOf("paper-001"), "--machine", folder.PathOf("slow.json"));
        var quiet = await CliRun.RunAsync("plan", SampleDrawing.PathOf("paper-001"), "--machine", folder.PathOf("slow.json"), "--quiet");

        const string Warning = "slow.json(2): warning MOT0023: The machine profile sets rapidMmPerMinute to 600, but feedMmPerMinute is 1200";
        Assert.All([check, plan], run => Assert.Equal((ExitCode.Done, 2), (run.ExitCode, run.Error.Split(Warning).Length)));
        Assert.Equal((ExitCode.Done, ""), (quiet.ExitCode, quiet.Error));
    }
}
