using Engraver.TestKit;

namespace Engraver.Cli.Tests.Posts;

/// <summary>The programs printed in paper 000, posted from the drawings in samples/paper-000.</summary>
public class PaperSampleTests
{
    private static string Folder => Path.Combine(RepositoryFolder.Samples, "paper-000");

    [Theory]
    [InlineData("table-1", "paper", "0,0")]
    [InlineData("table-1", "exact", "0,0")]
    [InlineData("linked-slot", "paper", "-2,0")]
    [InlineData("linked-slot", "exact", "-2,0")]
    [InlineData("belt", "paper", "2,11.83")]
    [InlineData("belt", "exact", "2,11.83")]
    public async Task Each_drawing_gives_the_program_that_stands_beside_it_and_is_verified(string name, string style, string start)
    {
        using var folder = new TemporaryFolder();
        var drawing = Path.Combine(Folder, name + ".dxf");
        var post = await CliRun.RunAsync("post", drawing, "--target", "agie", "--style", style, "--start=" + start, "-o", folder.PathOf("part.agie"));

        Assert.Equal(ExitCode.Done, post.ExitCode);
        GoldenFile.Check(Path.Combine(RepositoryFolder.Samples, "expected", "paper-000", $"{name}.{style}.agie"), await File.ReadAllTextAsync(folder.PathOf("part.agie")));
        if (style != "exact") return;
        var verified = await CliRun.RunAsync("verify", folder.PathOf("part.agie"), "--against", drawing, "--target", "agie", "--start=" + start, "--json");
        Assert.True(JsonText.Of(verified).GetProperty("ok").GetBoolean());
    }

    [Fact]
    public void The_nine_rows_that_the_paper_prints_stand_in_the_program()
    {
        var rows = File.ReadAllLines(Path.Combine(RepositoryFolder.Samples, "expected", "paper-000", "table-1.paper.agie"));

        Assert.Equal(443, rows.Length);
        Assert.Equal(
            [
                "%\t001\t03\t180\t060\t+000400\t+000400\t02", "\t002\t03\t210\t060\t+000400\t+000400\t02", "\t003\t01\t000\t000\t+020835\t-005788\t02",
                "\t004\t01\t000\t000\t+000752\t+000599\t02", "\t005\t03\t247\t053\t+002690\t+002690\t02", "\t006\t03\t300\t001\t+002361\t+002361\t02",
                "\t441\t01\t000\t000\t-000866\t-000418\t02", "\t442\t03\t028\t008\t+031000\t+031000\t02", "\t443\t03\t036\t001\t+005207\t+005207\t02\t02",
            ],
            [.. rows[..6], .. rows[^3..]]);
    }

    [Fact]
    public void The_worked_examples_have_their_printed_blocks()
    {
        string Block(string name, int block) => File.ReadAllLines(Path.Combine(RepositoryFolder.Samples, "expected", "paper-000", name))[block - 1];

        Assert.Equal("\t006\t01\t000\t000\t+050000\t+000000\t01", Block("linked-slot.exact.agie", 6));
        Assert.Equal("\t009\t02\t000\t180\t+003000\t+003000\t02\t02", Block("linked-slot.paper.agie", 9));
        Assert.Equal("\t004\t03\t280\t161\t+005000\t+005000\t02", Block("belt.paper.agie", 4));
        Assert.Equal("\t004\t03\t261\t018\t+010000\t+010000\t02", Block("belt.exact.agie", 4));
        Assert.Equal("\t010\t01\t000\t000\t-029166\t+004930\t02\t02", Block("belt.exact.agie", 10));
    }
}
