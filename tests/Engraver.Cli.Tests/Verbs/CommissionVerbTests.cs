namespace Engraver.Cli.Tests.Verbs;

/// <summary><c>engraver commission</c> with piped answers.</summary>
public class CommissionVerbTests
{
    private const string WithoutMoves = "Skip\nSkip\nSkip\nSkip\nSkip\nSkip\nSkip\nSkip\n";

    [Fact]
    public async Task Piped_answers_end_with_a_profile_that_machine_takes()
    {
        using var folder = new TemporaryFolder();
        var file = folder.PathOf("mine.json");

        var run = await CliRun.Typing("Skip\nSkip\nSkip\nSkip\nGo\n2000\n1000\nYes\nLeft\nYes\nYes\nBack\nYes\nSkip\nSkip\nSkip\nYes\n\n", "commission", "--connect", "sim:", "-o", file);

        Assert.True(run.ExitCode == ExitCode.Done, run.Out + run.Error);
        Assert.Contains("\"countsPerMillimetreX\": -1000", await File.ReadAllTextAsync(file), StringComparison.Ordinal);
        Assert.Contains("Axis A moves +1000 counts at 2000 counts/s, tool off. Is the path clear? [Yes/No] <No>:\n", run.Out, StringComparison.Ordinal);
        Assert.Contains("is now the machine profile. To load it later, use --machine.", run.Out, StringComparison.Ordinal); // The console does not have CNCPROFILE.
        var next = await CliRun.Typing(WithoutMoves + "No\n", "commission", "--connect", "sim:", "--machine", file);
        Assert.Equal(ExitCode.Done, next.ExitCode);
        Assert.Contains("X: axis A, -1000 counts/mm.", next.Out, StringComparison.Ordinal);
    }

    [Fact]
    public async Task An_input_that_ends_early_is_told_and_writes_nothing()
    {
        using var folder = new TemporaryFolder();
        var file = folder.PathOf("mine.json");

        var run = await CliRun.Typing("Skip\nGo\n", "commission", "--connect", "sim:", "-o", file);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("the input ended at the question \"Axis A: enter encoder signal", run.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(file));
    }

    [Fact]
    public async Task An_answer_that_is_not_understood_is_asked_again()
    {
        var run = await CliRun.Typing("soup\n" + WithoutMoves + "No\n", "commission", "--connect", "sim:");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains("'soup'", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Nobody_at_the_address_is_a_lost_link_and_a_profile_that_is_none_a_usage_error()
    {
        Assert.Equal(ExitCode.LinkLost, (await CliRun.Typing("", "commission", "--connect", "tcp://127.0.0.1:1")).ExitCode);
        Assert.Equal(ExitCode.Usage, (await CliRun.Typing("", "commission", "--connect", "sim:", "--machine", "none.json")).ExitCode);
    }
}
