namespace Engraver.Cli.Tests.Posts;

/// <summary>No verb overwrites the result of an earlier drawing with an empty result.</summary>
public class EarlierResultTests
{
    private const string NoCurve = "  0\nSECTION\n  2\nENTITIES\n  0\nTEXT\n  8\n0\n 10\n0\n 20\n0\n 40\n3\n  1\nhello\n  0\nENDSEC\n  0\nEOF\n";

    public static TheoryData<string> Unreadable => ["missing", "AC1032\0\0\0", "\u007fELF\u0001\u0002", ""];

    public static IReadOnlyList<string[]> Ways { get; } =
    [
        ["sequence", "-o"], ["plot", "-o"], ["post", "--target", "galil", "-o"], ["post", "--target", "galil-calls", "-o"], ["post", "--target", "cldata", "-o"], ["post", "--target", "agie", "-o"],
    ];

    [Theory]
    [MemberData(nameof(Unreadable))]
    public async Task A_drawing_that_cannot_be_read_replaces_nothing(string content)
    {
        foreach (var way in Ways)
        {
            using var folder = new TemporaryFolder();
            var drawing = content == "missing" ? folder.PathOf("missing.dxf") : folder.WithFile("drawing.dxf", content);
            var earlier = folder.WithFile("result", "earlier");
            var run = await CliRun.RunAsync([way[0], drawing, .. way[1..], earlier]);

            Assert.Equal((way[0], ExitCode.DrawingError, "earlier"), (way[0], run.ExitCode, await File.ReadAllTextAsync(earlier)));
            Assert.DoesNotContain("DOC0002", run.Error, StringComparison.Ordinal); // The reason is printed once.
        }
    }

    [Fact]
    public async Task A_drawing_without_a_curve_makes_no_program_and_that_is_an_error_by_name()
    {
        foreach (var way in Ways.Where(way => way[0] != "plot"))
        {
            using var folder = new TemporaryFolder();
            var earlier = folder.WithFile("result", "earlier");
            var run = await CliRun.RunAsync([way[0], folder.WithFile("text.dxf", NoCurve), .. way[1..], earlier]);

            Assert.Equal((ExitCode.DrawingError, "earlier"), (run.ExitCode, await File.ReadAllTextAsync(earlier)));
            Assert.Contains("error DOC0002", run.Error, StringComparison.Ordinal);
        }
    }
}
