namespace Engraver.Cli.Tests.Verbs;

public class TerminalVerbTests
{
    [Fact]
    public async Task Piped_commands_are_answered_one_line_each_on_standard_output()
    {
        var run = await CliRun.Typing("x=4\nMG x*2\nTPA\n", "terminal", "--connect", "sim:");

        Assert.Equal((ExitCode.Done, ":\n8.0000\n0\n", ""), (run.ExitCode, run.Out, run.Error));
    }

    [Fact]
    public async Task A_refusal_is_answered_and_told_by_the_exit_code_and_the_next_line_goes_on()
    {
        var run = await CliRun.Typing("BGS\nMG 7\n", "terminal", "--connect", "sim:");

        Assert.Equal(ExitCode.Refused, run.ExitCode);
        Assert.Equal("? 24 Begin not valid because no sequence defined: no segment was buffered\n7.0000\n", run.Out);
    }

    [Fact]
    public async Task A_dangerous_command_is_not_sent_without_the_word_of_confirmation()
    {
        var run = await CliRun.Typing("x=1\nST\nMG x\n", "terminal", "--connect", "sim:");

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("type: confirm ST\n", run.Out, StringComparison.Ordinal);
        Assert.Equal(ExitCode.Done, (await CliRun.Typing("confirm ST\n", "terminal", "--connect", "sim:")).ExitCode);
    }

    [Fact]
    public async Task Help_and_history_are_answered_by_the_terminal_and_quit_ends_it()
    {
        var run = await CliRun.Typing("help 22\nhelp VE\nhistory\nquit\nMG 1\n", "terminal", "--connect", "sim:");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.StartsWith("TC 22  Begin not possible due to limit switch", run.Out, StringComparison.Ordinal);
        Assert.EndsWith("help 22\nhelp VE\nhistory\n", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_pipe_has_no_colours() => Assert.DoesNotContain('\e', (await CliRun.Typing("MG 1\nFOO\n", "terminal", "--connect", "sim:")).Out);

    [Fact]
    public async Task Nobody_at_the_address_is_a_lost_link() =>
        Assert.Equal(ExitCode.LinkLost, (await CliRun.Typing("MG 1\n", "terminal", "--connect", "tcp://127.0.0.1:1")).ExitCode);

    [Fact]
    public async Task The_operators_stop_does_not_wait_for_the_next_line()
    {
        using var stop = new CancellationTokenSource();
        using var silent = new SilentReader(stop.Cancel);
        var run = await CliRun.Typing(silent, stop.Token, "terminal", "--connect", "sim:");
        silent.Release();

        Assert.Equal(ExitCode.StoppedByOperator, run.ExitCode);
    }

    /// <summary>Input without data that ends with Ctrl-C.</summary>
    private sealed class SilentReader(Action pressed) : TextReader
    {
        private readonly ManualResetEventSlim _released = new();

        public void Release() => _released.Set();

        public override string? ReadLine()
        {
            pressed();
            _released.Wait();
            return null;
        }
    }
}
