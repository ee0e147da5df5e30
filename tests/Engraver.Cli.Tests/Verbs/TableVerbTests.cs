namespace Engraver.Cli.Tests.Verbs;

public class TableVerbTests
{
    [Fact]
    public async Task The_papers_table_comes_out_as_analysed_and_sequenced()
    {
        var run = await CliRun.RunAsync("table", SampleDrawing.PathOf("paper-001"), "--format", "csv");

        Assert.Equal(
            """
            s0,s1,s2,s3,s4,s5,s6,s7,s8,s9,s10,s11,s12,s13,s14,s15
            1,50,50,0,150,50,0,0,0,0,0,0,0,1,0,0
            1,150,50,0,150,150,0,0,0,0,0,0,0,2,0,0
            3,150,150,0,50,150,0,100,150,0,50,0,180,3,0,180
            1,50,150,0,50,50,0,0,0,0,0,0,0,4,0,0

            """.ReplaceLineEndings("\n"),
            run.Out);
    }

    [Fact]
    public async Task As_drawn_is_not_sequenced()
    {
        var rows = JsonText.Of(await CliRun.RunAsync("table", SampleDrawing.PathOf("paper-001"), "--format", "json", "--as-drawn")).GetProperty("rows");

        Assert.Equal(4, rows.GetArrayLength());
        Assert.All(rows.EnumerateArray(), row => Assert.Equal(0, row[13].GetInt32()));
    }

    [Fact]
    public async Task Inches_become_millimetres_in_the_table()
    {
        using var folder = new TemporaryFolder();
        var file = folder.WithFile("inch.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n2\n21\n0\n0\nENDSEC\n0\nEOF\n");
        var run = await CliRun.RunAsync("table", file, "--format", "csv", "--units", "inch");

        Assert.Contains("\n1,0,0,0,50.8,0,0,", run.Out, StringComparison.Ordinal);
    }
}
