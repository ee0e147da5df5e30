using System.Text;

namespace Engraver.Cli.Tests.Runs;

/// <summary>An operator at a terminal holds a run, resumes it and changes its speed.</summary>
public class RunKeysTests
{
    [Theory]
    [InlineData("stream")]
    [InlineData("calls")]
    [InlineData("program")]
    public async Task H_holds_R_resumes_and_plus_and_minus_change_the_feed(string mode)
    {
        var keys = new Queue<char?>([.. Nothing(6), '-', '-', '<', 'h', .. Nothing(200), 'r', .. Nothing(2), '0']);

        var run = await WithKeysAsync(keys, "run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--mode", mode, "--json");

        Assert.Equal(0, run.ExitCode);
        var report = JsonText.Of(run);
        Assert.Equal(("complete", 1), (report.GetProperty("outcome").GetString(), report.GetProperty("holds").GetInt32()));
        Assert.Equal(0.0, report.GetProperty("missingLength").GetDouble());
        Assert.Contains("Keys: h hold", run.Error, StringComparison.Ordinal);
        Assert.Contains("Feed 80 %, rapid 100 %.", run.Error, StringComparison.Ordinal);
        Assert.Contains("Feed 80 %, rapid 90 %.", run.Error, StringComparison.Ordinal);
        Assert.Contains("HELD", run.Error, StringComparison.Ordinal);
        Assert.Contains("Feed 100 %, rapid 90 %.", run.Error, StringComparison.Ordinal);
        Assert.Empty(keys);
    }

    [Theory]
    [InlineData("stream")]
    [InlineData("calls")]
    [InlineData("program")]
    public async Task Arrows_step_a_held_machine_away_and_r_comes_back_to_the_place(string mode)
    {
        const char Right = '\u2192', Up = '\u2191';
        var keys = new Queue<char?>([.. Nothing(3), Right, .. Nothing(6), 'h', .. Nothing(40), Right, .. Nothing(60), Up, .. Nothing(60), 'r']);

        var run = await WithKeysAsync(keys, "run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--mode", mode, "--json");

        Assert.Equal(0, run.ExitCode);
        var report = JsonText.Of(run);
        Assert.Equal(("complete", 1, 0.0), (report.GetProperty("outcome").GetString(), report.GetProperty("holds").GetInt32(), report.GetProperty("missingLength").GetDouble()));
        Assert.Contains("job is not held", run.Error, StringComparison.Ordinal); // the first arrow
        var places = run.Error.Split('\n').Where(line => line.StartsWith("The machine is at ", StringComparison.Ordinal)).Select(line => line["The machine is at ".Length..^" mm.".Length].Split(',').Select(Double).ToList()).ToList();
        Assert.Equal(2, places.Count);
        Assert.Equal((0.0, 1.0), (Math.Round(places[1][0] - places[0][0], 3), Math.Round(places[1][1] - places[0][1], 3)));
    }

    private static double Double(string number) => double.Parse(number, System.Globalization.CultureInfo.InvariantCulture);

    [Fact]
    public async Task Without_a_keyboard_nothing_is_said_of_keys()
    {
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:");

        Assert.Equal(0, run.ExitCode);
        Assert.DoesNotContain("Keys", run.Error, StringComparison.Ordinal);
    }

    private static ConsoleKey Arrow(char key) => key switch { '\u2192' => ConsoleKey.RightArrow, '\u2191' => ConsoleKey.UpArrow, _ => default };

    private static IEnumerable<char?> Nothing(int looks) => Enumerable.Repeat(default(char?), looks);

    /// <summary>Each poll of the keyboard returns the next key or none.</summary>
    private static async Task<CliRun> WithKeysAsync(Queue<char?> keys, params string[] args)
    {
        using var output = new MemoryStream();
        await using var error = new StringWriter();
        int code;
        using (var streams = new ConsoleStreams(output, error) { Keys = () => keys.TryDequeue(out var key) && key is { } pressed ? new ConsoleKeyInfo(pressed, Arrow(pressed), false, false, false) : null })
        {
            code = await EngraverProgram.RunAsync(args, streams, CancellationToken.None);
        }

        return new CliRun(code, Encoding.UTF8.GetString(output.ToArray()), error.ToString());
    }
}
