using System.Globalization;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Verbs;

public class RecoverArcsTests
{
    [Fact]
    public async Task Lines_that_draw_an_arc_are_cut_as_one_and_said_so()
    {
        using var folder = new TemporaryFolder();
        var path = folder.PathOf("flattened.dxf");
        await File.WriteAllBytesAsync(path, Quarter());

        var asDrawn = JsonText.Of(await CliRun.RunAsync("sequence", path, "--json", "--max-error", "0.01"));
        var run = await CliRun.RunAsync("sequence", path, "--json", "--max-error", "0.01", "--recover-arcs", "--verbose");

        Assert.Equal(40, asDrawn.GetProperty("segments").GetInt32());
        Assert.Equal(1, JsonText.Of(run).GetProperty("segments").GetInt32());
        Assert.Contains("SEQ0010", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_posted_program_has_one_arc_and_still_passes_its_verification()
    {
        using var folder = new TemporaryFolder();
        var (path, program) = (folder.PathOf("flattened.dxf"), folder.PathOf("out.dmc"));
        await File.WriteAllBytesAsync(path, Quarter());

        await CliRun.RunAsync("post", path, "--target", "galil", "-o", program, "--max-error", "0.01", "--recover-arcs");
        var verified = await CliRun.RunAsync("verify", program, "--against", path, "--json", "--max-error", "0.01");

        var lines = await File.ReadAllTextAsync(program);
        Assert.Equal(1, lines.Split("CR").Length - 1);
        Assert.True(JsonText.Of(verified).GetProperty("maxDeviation").GetDouble() < 0.013);
    }

    private static byte[] Quarter()
    {
        var pairs = new List<(int, object)>();
        for (var i = 0; i < 40; i++)
        {
            pairs.AddRange([(0, "LINE"), (8, "0"), (10, Text(Math.Cos, i)), (20, Text(Math.Sin, i)), (11, Text(Math.Cos, i + 1)), (21, Text(Math.Sin, i + 1))]);
        }

        return DxfText.WithEntities([.. pairs]).ToAscii();
    }

    private static string Text(Func<double, double> coordinate, int step) => (20.0 * coordinate(step * Math.PI / 80.0)).ToString("F6", CultureInfo.InvariantCulture);
}
