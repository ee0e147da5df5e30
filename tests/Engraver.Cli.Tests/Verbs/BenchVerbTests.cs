namespace Engraver.Cli.Tests.Verbs;

public class BenchVerbTests
{
    [Fact]
    public async Task Every_size_has_a_row_for_each_stage_under_one_head()
    {
        var run = await CliRun.RunAsync("bench", "20", "30");
        var lines = run.Out.TrimEnd('\n').Split('\n');

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.StartsWith("| Entities | Stage |", lines[0], StringComparison.Ordinal);
        Assert.Equal((2 + 8 + 8, 8, 8), (lines.Length, lines.Count(line => line.StartsWith("| 20 |", StringComparison.Ordinal)), lines.Count(line => line.StartsWith("| 30 |", StringComparison.Ordinal))));
    }

    [Theory]
    [InlineData("0")]
    [InlineData("-5")]
    [InlineData("many")]
    public async Task A_size_that_is_no_number_of_lines_is_a_usage_error(string size) => Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync("bench", size)).ExitCode);
}
