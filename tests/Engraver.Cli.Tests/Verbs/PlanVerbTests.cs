namespace Engraver.Cli.Tests.Verbs;

public class PlanVerbTests
{
    public static TheoryData<string> Samples => new(SampleDrawing.Names);

    [Theory]
    [MemberData(nameof(Samples))]
    public async Task The_planned_time_is_within_two_percent_of_the_simulated_run(string name)
    {
        using var folder = new TemporaryFolder();
        var plan = JsonText.Of(await CliRun.RunAsync("plan", SampleDrawing.PathOf(name), "--json"));
        var run = JsonText.Of(await CliRun.RunAsync("run", SampleDrawing.PathOf(name), "--connect", "sim:", "--json", "--journal", folder.PathOf("run.jsonl")));
        var (planned, simulated) = (plan.GetProperty("seconds").GetProperty("total").GetDouble(), run.GetProperty("seconds").GetDouble());

        Assert.InRange(planned, 0.98 * simulated, 1.02 * simulated);
        Assert.Equal(planned, run.GetProperty("plannedSeconds").GetDouble(), precision: 9);
    }

    [Theory]
    [MemberData(nameof(Samples))]
    public async Task So_is_the_time_planned_for_the_papers_calls(string name)
    {
        using var folder = new TemporaryFolder();
        var run = JsonText.Of(await CliRun.RunAsync("run", SampleDrawing.PathOf(name), "--connect", "sim:", "--mode", "calls", "--json", "--journal", folder.PathOf("run.jsonl")));
        var simulated = run.GetProperty("seconds").GetDouble();

        Assert.InRange(run.GetProperty("plannedSeconds").GetDouble(), 0.98 * simulated, 1.02 * simulated);
    }

    [Fact]
    public async Task The_object_has_every_field_of_the_contract_and_its_seconds_add_up()
    {
        var plan = JsonText.Of(await CliRun.RunAsync("plan", SampleDrawing.PathOf("paper-001"), "--json"));
        var seconds = plan.GetProperty("seconds");

        Assert.Equal(["seconds", "cutLength", "travel", "peakSpeed", "peakAxisAcceleration", "cost", "notCut", "costParts", "uncut", "fonts", "plates"], plan.EnumerateObject().Select(field => field.Name));
        Assert.Equal(["total", "cutting", "rapid", "dwell"], seconds.EnumerateObject().Select(field => field.Name));
        Assert.Equal(seconds.GetProperty("total").GetDouble(), seconds.GetProperty("cutting").GetDouble() + seconds.GetProperty("rapid").GetDouble() + seconds.GetProperty("dwell").GetDouble(), precision: 12);
        Assert.Equal(300.0 + (50.0 * Math.PI), plan.GetProperty("cutLength").GetDouble(), precision: 9);
        Assert.Equal(20.0, plan.GetProperty("peakSpeed").GetDouble(), precision: 6);
    }

    [Fact]
    public async Task Rates_give_a_cost_by_time_length_and_starts_and_none_give_none()
    {
        var plain = JsonText.Of(await CliRun.RunAsync("plan", SampleDrawing.PathOf("nameplate"), "--json"));
        var plan = JsonText.Of(await CliRun.RunAsync("plan", SampleDrawing.PathOf("nameplate"), "--json", "--rate", "72,10.5,0.25"));
        var parts = plan.GetProperty("costParts");
        var strokes = JsonText.Of(await CliRun.RunAsync("sequence", SampleDrawing.PathOf("nameplate"), "--json")).GetProperty("strokes").GetArrayLength();

        Assert.Equal(System.Text.Json.JsonValueKind.Null, plain.GetProperty("cost").ValueKind);
        Assert.Equal(72.0 * plan.GetProperty("seconds").GetProperty("total").GetDouble() / 3600.0, parts.GetProperty("time").GetDouble(), precision: 9);
        Assert.Equal(10.5 * plan.GetProperty("cutLength").GetDouble() / 1000.0, parts.GetProperty("length").GetDouble(), precision: 9);
        Assert.Equal(0.25 * strokes, parts.GetProperty("starts").GetDouble(), precision: 9);
        Assert.Equal(parts.GetProperty("time").GetDouble() + parts.GetProperty("length").GetDouble() + parts.GetProperty("starts").GetDouble(), plan.GetProperty("cost").GetDouble(), precision: 9);
        Assert.True(strokes > 1);
    }

    [Fact]
    public async Task The_rates_of_the_profile_count_where_none_are_given_and_stand_on_the_sheet()
    {
        var eroder = Path.Combine(Engraver.TestKit.RepositoryFolder.Samples, "machine-eroder.json");
        var plan = JsonText.Of(await CliRun.RunAsync("plan", SampleDrawing.PathOf("paper-001"), "--machine", eroder, "--json"));
        var given = JsonText.Of(await CliRun.RunAsync("plan", SampleDrawing.PathOf("paper-001"), "--machine", eroder, "--rate", "1", "--json"));
        var sheet = await CliRun.RunAsync("plan", SampleDrawing.PathOf("paper-001"), "--machine", eroder, "--sheet");
        var (hours, metres) = (plan.GetProperty("seconds").GetProperty("total").GetDouble() / 3600.0, plan.GetProperty("cutLength").GetDouble() / 1000.0);

        Assert.Equal((45.0 * hours) + (12.0 * metres) + 3.5, plan.GetProperty("cost").GetDouble(), precision: 9);
        Assert.Equal(hours, given.GetProperty("cost").GetDouble(), precision: 9);
        Assert.Contains("Cost of starts  3.50 (3.5 per start)\n", sheet.Out, StringComparison.Ordinal);
        Assert.Contains($"Cost            {plan.GetProperty("cost").GetDouble().ToString("0.00", System.Globalization.CultureInfo.InvariantCulture)}\n", sheet.Out, StringComparison.Ordinal);
        Assert.Contains("Cut length      0.457 m\n", sheet.Out, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Operations_and_tools_have_times_and_costs_whose_sums_are_those_of_the_job()
    {
        string[] job = ["plan", SampleDrawing.PathOf("finished-plate"), "--cut", "text", "--operations", Sample("finished-plate.operations.json"), "--machine", Sample("machine-mill.json"), "--rate", "72,10.5,0.25"];
        var plan = JsonText.Of(await CliRun.RunAsync([.. job, "--json"]));
        var (operations, tools, around) = (plan.GetProperty("operations").EnumerateArray().ToList(), plan.GetProperty("tools").EnumerateArray().ToList(), plan.GetProperty("around"));
        var one = JsonText.Of(await CliRun.RunAsync([.. job, "--json", "--tool-number", tools[1].GetProperty("tool").ToString()]));
        var sheet = await CliRun.RunAsync([.. job, "--sheet"]);

        foreach (var parts in new[] { operations, tools })
        {
            Assert.Equal(plan.GetProperty("cutLength").GetDouble(), parts.Sum(part => part.GetProperty("length").GetDouble()), precision: 6);
            foreach (var (of, name) in new[] { ("seconds", "total"), ("seconds", "cutting"), ("seconds", "rapid"), ("seconds", "dwell"), ("costParts", "time"), ("costParts", "length"), ("costParts", "starts") })
            {
                Assert.Equal(plan.GetProperty(of).GetProperty(name).GetDouble(), around.GetProperty(of).GetProperty(name).GetDouble() + parts.Sum(part => part.GetProperty("planned").GetProperty(of).GetProperty(name).GetDouble()), precision: 6);
            }

            Assert.Equal(plan.GetProperty("cost").GetDouble(), around.GetProperty("cost").GetDouble() + parts.Sum(part => part.GetProperty("planned").GetProperty("cost").GetDouble()), precision: 6);
            Assert.Equal(plan.GetProperty("costParts").GetProperty("starts").GetDouble(), 0.25 * parts.Sum(part => part.GetProperty("strokes").GetInt32()), precision: 6);
        }

        Assert.Equal(one.GetProperty("seconds").GetProperty("cutting").GetDouble(), tools[1].GetProperty("planned").GetProperty("seconds").GetProperty("cutting").GetDouble(), precision: 6);
        Assert.True(around.GetProperty("seconds").GetProperty("rapid").GetDouble() > 0.0);
        var lines = sheet.Out.Split('\n');
        Assert.Equal((operations.Count, tools.Count, 1), (lines.Count(line => line.StartsWith("Operation ", StringComparison.Ordinal)), lines.Count(line => line.StartsWith("Tool ", StringComparison.Ordinal)), lines.Count(line => line.StartsWith("Start and finish ", StringComparison.Ordinal))));
        Assert.Contains(FormattableString.Invariant($"cost {operations[0].GetProperty("planned").GetProperty("cost").GetDouble():0.00}"), lines.First(line => line.StartsWith("Operation ", StringComparison.Ordinal)), StringComparison.Ordinal);

        static string Sample(string name) => Path.Combine(Engraver.TestKit.RepositoryFolder.Samples, name);
    }

    [Fact]
    public async Task Operations_without_rates_have_times_and_no_cost()
    {
        var plan = JsonText.Of(await CliRun.RunAsync("plan", SampleDrawing.PathOf("operation-plate"), "--operations", Path.Combine(Engraver.TestKit.RepositoryFolder.Samples, "operation-plate.operations.json"), "--machine", Path.Combine(Engraver.TestKit.RepositoryFolder.Samples, "machine-mill.json"), "--json"));
        var planned = plan.GetProperty("operations")[0].GetProperty("planned");

        Assert.True(planned.GetProperty("seconds").GetProperty("cutting").GetDouble() > 0.0);
        Assert.Equal((System.Text.Json.JsonValueKind.Null, System.Text.Json.JsonValueKind.Null), (planned.GetProperty("cost").ValueKind, planned.GetProperty("costParts").ValueKind));
    }

    [Theory]
    [InlineData("free")]
    [InlineData("-1")]
    [InlineData("1,2,3,4")]
    [InlineData("1,,2")]
    [InlineData("1e400")]
    public async Task Rates_that_cannot_be_read_are_a_usage_error(string rates) =>
        Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync("plan", SampleDrawing.PathOf("nameplate"), "--rate", rates)).ExitCode);

    [Fact]
    public async Task The_machine_profile_decides_how_long_it_takes()
    {
        using var folder = new TemporaryFolder();
        var slow = JsonText.Of(await CliRun.RunAsync("plan", SampleDrawing.PathOf("paper-001"), "--json", "--machine", folder.WithFile("slow.json", """{ "feedMmPerMinute": 600 }""")));
        var usual = JsonText.Of(await CliRun.RunAsync("plan", SampleDrawing.PathOf("paper-001"), "--json"));

        Assert.Equal(10.0, slow.GetProperty("peakSpeed").GetDouble(), precision: 6);
        Assert.InRange(Cutting(slow), 1.9 * Cutting(usual), 2.0 * Cutting(usual));

        static double Cutting(System.Text.Json.JsonElement plan) => plan.GetProperty("seconds").GetProperty("cutting").GetDouble();
    }

    [Fact]
    public async Task A_drawing_that_cannot_be_read_is_told_and_takes_no_time()
    {
        var run = await CliRun.RunAsync("plan", "missing.dxf", "--json");

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Equal(0.0, JsonText.Of(run).GetProperty("seconds").GetProperty("total").GetDouble());
    }
}
