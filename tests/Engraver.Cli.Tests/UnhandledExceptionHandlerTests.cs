namespace Engraver.Cli.Tests;

/// <summary>An exception on a background thread ends the program with a report.</summary>
public class UnhandledExceptionHandlerTests
{
    [Fact]
    public async Task A_bug_on_a_thread_of_the_pool_ends_the_process_with_70_and_a_report()
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.StartWithBug("simulate");
        await simulate.LineAsync("listening ", patience.Token);

        simulate.Signal(StartupHook.Trigger);

        await simulate.WaitAsync(patience.Token);
        Assert.Equal(ExitCode.InternalError, simulate.ExitCode);
        var said = await simulate.Error.ReadToEndAsync(patience.Token);
        Assert.Contains("engraver: internal error (NotSupportedException: a thread of the pool broke)", said, StringComparison.Ordinal);
        File.Delete(System.Text.RegularExpressions.Regex.Match(said, "[^ ]+engraver-crash-[^ ;]+\\.txt").Value);
    }

    [Fact]
    public void A_bug_that_nobody_caught_is_exit_70_and_names_its_report()
    {
        using var error = new StringWriter();
        var exits = new List<int>();

        new UnhandledExceptionHandler(["simulate", "--tcp", "0"], error, exits.Add).Handle(new NotSupportedException("a thread broke"));

        Assert.Equal([ExitCode.InternalError], exits);
        var said = Assert.Single(error.ToString().TrimEnd().Split('\n'));
        Assert.StartsWith("engraver: internal error (NotSupportedException: a thread broke)", said, StringComparison.Ordinal);
        var report = Assert.Single(System.Text.RegularExpressions.Regex.Matches(said, "[^ ]+engraver-crash-[^ ;]+\\.txt")).Value;
        Assert.Contains("simulate --tcp 0", File.ReadAllText(report), StringComparison.Ordinal);
        File.Delete(report);
    }

    [Fact]
    public void The_first_of_several_bugs_is_the_one_that_is_told()
    {
        using var error = new StringWriter();
        var exits = new List<int>();
        var resort = new UnhandledExceptionHandler([], error, exits.Add);

        resort.Handle(new NotSupportedException("the first"));
        resort.Handle(new NotSupportedException("the second"));

        Assert.Single(exits);
        Assert.DoesNotContain("the second", error.ToString(), StringComparison.Ordinal);
        File.Delete(System.Text.RegularExpressions.Regex.Match(error.ToString(), "[^ ]+engraver-crash-[^ ;]+\\.txt").Value);
    }
}
