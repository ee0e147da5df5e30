using System.Text.Json.Nodes;

namespace Engraver.Cli.Tests.Posts;

/// <summary>The wire EDM program through the console: posted, with forecast, read back.</summary>
public class AgieFileTests
{
    [Fact]
    public async Task A_posted_program_is_verified_and_a_spoiled_one_names_its_line()
    {
        using var folder = new TemporaryFolder();
        var program = folder.PathOf("gasket.agie");
        var posted = await CliRun.RunAsync("post", SampleDrawing.PathOf("gasket"), "--target", "agie", "-o", program);
        var verified = await CliRun.RunAsync("verify", program, "--against", SampleDrawing.PathOf("gasket"), "--target", "agie", "--json");
        await File.WriteAllTextAsync(program, (await File.ReadAllTextAsync(program)).Replace("\t003\t", "\t004\t", StringComparison.Ordinal));
        var spoiled = await CliRun.RunAsync("verify", program, "--against", SampleDrawing.PathOf("gasket"), "--target", "agie");

        Assert.Equal((ExitCode.Done, ExitCode.Done, ExitCode.DrawingError), (posted.ExitCode, verified.ExitCode, spoiled.ExitCode));
        Assert.Contains("block 001  at ", posted.Out, StringComparison.Ordinal);
        Assert.Contains("maximum deviation from the path: 0.000", posted.Out, StringComparison.Ordinal);
        Assert.True((bool)JsonNode.Parse(verified.Out)!["ok"]!);
        Assert.Contains("gasket.agie(3): error PST0001", spoiled.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_program_is_verified_and_certified_from_the_start_that_is_kept_beside_it()
    {
        using var folder = new TemporaryFolder();
        var (program, drawing) = (folder.PathOf("gasket.agie"), SampleDrawing.PathOf("gasket"));
        await CliRun.RunAsync("post", drawing, "--target", "agie", "-o", program, "--start", "1000,1000");
        var verified = await CliRun.RunAsync("verify", program, "--against", drawing);
        var certified = await CliRun.RunAsync("certify", drawing, "--target", "agie", "--program", program, "-o", folder.PathOf("c.json"));
        File.Delete(program + ".start.json");
        var lost = await CliRun.RunAsync("verify", program, "--against", drawing);

        Assert.Equal((ExitCode.Done, ExitCode.Done, ExitCode.DrawingError), (verified.ExitCode, certified.ExitCode, lost.ExitCode));
    }

    [Fact]
    public async Task The_forecast_is_one_json_object_with_or_without_a_file()
    {
        using var folder = new TemporaryFolder();
        var inside = JsonNode.Parse((await CliRun.RunAsync("post", SampleDrawing.PathOf("gasket"), "--target", "agie", "--json")).Out)!;
        var beside = JsonNode.Parse((await CliRun.RunAsync("post", SampleDrawing.PathOf("gasket"), "--target", "agie", "--json", "-o", folder.PathOf("out.agie"))).Out)!;
        var other = JsonNode.Parse((await CliRun.RunAsync("post", SampleDrawing.PathOf("gasket"), "--target", "galil", "--json")).Out)!;

        Assert.Equal((string)inside["text"]!, await File.ReadAllTextAsync(folder.PathOf("out.agie")));
        Assert.Equal((null, folder.PathOf("out.agie")), ((string?)beside["text"], (string?)beside["file"]));
        Assert.InRange((double)beside["forecast"]!["maxError"]!, 0.0, 0.0011);
        Assert.Equal((int)beside["lines"]!, beside["forecast"]!["blocks"]!.AsArray().Count);
        Assert.Null(other["forecast"]);
    }

    [Fact]
    public async Task Whole_degrees_are_a_warning_and_the_style_of_another_target_is_a_usage_error()
    {
        var paper = await CliRun.RunAsync("post", SampleDrawing.PathOf("gasket"), "--target", "agie", "--style", "paper");
        var wrong = await CliRun.RunAsync("post", SampleDrawing.PathOf("gasket"), "--target", "galil", "--style", "paper");

        Assert.Equal(ExitCode.Done, paper.ExitCode);
        Assert.Contains("warning PST0004", paper.Error, StringComparison.Ordinal);
        Assert.Equal(ExitCode.Usage, wrong.ExitCode);
    }
}
