using Engraver.Benchmarks.Stages;

namespace Engraver.Workbench.Tests.Benchmarks;

public class StageBenchmarkTests
{
    [Fact]
    public async Task Every_stage_has_its_row_and_the_simulated_cut_misses_nothing()
    {
        var rows = await StageBenchmark.RunAsync(100, CancellationToken.None);

        Assert.Equal(["read", "table and analysis", "chain", "order", "generate", "toolpath check", "simulate and judge", "verify"], rows.Select(row => row.Stage));
        Assert.All(rows, row => Assert.Equal(100, row.Entities));
        Assert.Equal("100 rows", rows[1].Note);
        Assert.All(rows.TakeLast(2), row => Assert.Matches(@"^[1-9][0-9]* s of machine time, [0-9]+ times real time, worst 0\.00[0-9]{2} mm, missing 0 mm$", row.Note));
        Assert.Matches(@"^\| 100 \| read \| [0-9.]+ \| [0-9]+ \| [0-9]+ \| 0\.0 MB \|$", rows[0].ToMarkdown());
    }
}
