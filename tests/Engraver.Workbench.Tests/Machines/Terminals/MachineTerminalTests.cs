using Engraver.Core.Machines;
using Engraver.Galil.Sessions;
using Engraver.Galil.Terminals;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Tests.Machines.Terminals;

public class MachineTerminalTests
{
    [Fact]
    public async Task Replies_refusals_and_silent_commands_are_told_apart()
    {
        await using var connection = Simulated();
        await using var terminal = await MachineTerminal.OpenAsync(connection.OpenLinkAsync, TimeProvider.System, CancellationToken.None);

        Assert.Equal([new TerminalAnswer(TerminalAnswerKind.Reply, "3.0000")], await terminal.ExecuteLineAsync("MG 1+2", CancellationToken.None));
        Assert.Equal([new TerminalAnswer(TerminalAnswerKind.Reply, ":")], await terminal.ExecuteLineAsync("x=4", CancellationToken.None));
        Assert.Equal(
            [new TerminalAnswer(TerminalAnswerKind.Refusal, "? 1 Unrecognized command: this firmware does not have the command (commands are upper case)")],
            await terminal.ExecuteLineAsync("bg", CancellationToken.None));
        Assert.Equal(TerminalAnswerKind.Withheld, (await terminal.ExecuteLineAsync("RS", CancellationToken.None)).Single().Kind);
        Assert.Equal(["MG 1+2", "x=4", "bg", "RS"], terminal.History);
    }

    [Fact]
    public async Task What_a_program_prints_comes_as_a_message_before_the_next_answer()
    {
        await using var connection = Simulated();
        await using var terminal = await MachineTerminal.OpenAsync(connection.OpenLinkAsync, TimeProvider.System, CancellationToken.None);
        await terminal.Session.Commands.DownloadAsync("#HELLO\nMG \"HELLO\"\nEN\n", CancellationToken.None);

        var answers = (await terminal.ExecuteLineAsync("XQ#HELLO", CancellationToken.None)).ToList();
        for (var i = 0; i < 20 && !answers.Exists(answer => answer.Kind == TerminalAnswerKind.Message); i++) answers.AddRange(await terminal.PollAsync(CancellationToken.None));

        Assert.Contains(new TerminalAnswer(TerminalAnswerKind.Message, "HELLO"), answers);
    }

    [Fact]
    public async Task The_program_in_the_controller_can_be_listed()
    {
        await using var connection = Simulated();
        await using var terminal = await MachineTerminal.OpenAsync(connection.OpenLinkAsync, TimeProvider.System, CancellationToken.None);
        await terminal.Session.Commands.DownloadAsync("#A\nEN\n", CancellationToken.None);

        Assert.Equal([new TerminalAnswer(TerminalAnswerKind.Reply, "#A\nEN")], await terminal.ExecuteLineAsync("UL", CancellationToken.None));
    }

    [Fact]
    public async Task The_operators_stop_brings_a_jogging_axis_to_rest()
    {
        await using var connection = Simulated();
        await using var terminal = await MachineTerminal.OpenAsync(connection.OpenLinkAsync, TimeProvider.System, CancellationToken.None);
        foreach (var line in new[] { "SHC", "JGC=1000", "BGC" }) Assert.Equal(":", (await terminal.ExecuteLineAsync(line, CancellationToken.None)).Single().Text);

        await terminal.StopAsync(toolOutput: 1, TimeSpan.Zero);

        for (var i = 0; i < 100 && (await terminal.Session.Commands.ReadAsync("_BGC", CancellationToken.None)).ValuesOrEmpty != 0.0; i++) await terminal.PollAsync(CancellationToken.None);
        Assert.Equal(0.0, (await terminal.Session.Commands.ReadAsync("_BGC", CancellationToken.None)).ValuesOrEmpty);
    }

    /// <summary>ADR 4: the tool is switched off before any deceleration.</summary>
    [Fact]
    public async Task The_operators_stop_switches_the_tool_off_before_an_axis_brakes()
    {
        await using var connection = MachineConnection.To(new SimulatedAddress(double.PositiveInfinity), TimeProvider.System, keepsRecord: true);
        using var clock = connection.CreateClock(); // Time advances only with commands.
        await using var terminal = await MachineTerminal.OpenAsync(connection.OpenLinkAsync, clock.Time, CancellationToken.None);
        foreach (var line in new[] { "SB 1", "SHC", "JGC=20000", "BGC" }) Assert.Equal(":", (await terminal.ExecuteLineAsync(line, CancellationToken.None)).Single().Text);
        connection.Simulator!.Advance(TimeSpan.FromSeconds(1));
        var pressedAt = connection.Simulator.Status.Sample;

        await terminal.StopAsync(toolOutput: 1, TimeSpan.Zero);

        var after = connection.Simulator.Record.Snapshot().Where(row => row.Sample > pressedAt).ToList();
        Assert.NotEmpty(after);
        Assert.All(after, row => Assert.Equal(0, row.Outputs));
    }

    private static MachineConnection Simulated() => MachineConnection.To(new SimulatedAddress(double.PositiveInfinity), TimeProvider.System);
}
