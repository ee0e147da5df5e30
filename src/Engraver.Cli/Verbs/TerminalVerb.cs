using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Terminals;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver terminal</c>: a line terminal to a controller, typed or piped.</summary>
internal static class TerminalVerb
{
    private static readonly TimeSpan s_poll = TimeSpan.FromMilliseconds(20);

    public static Command Build(VerbHost host)
    {
        var connect = ConnectOption.New(required: true, Wording.Get("Terminal.Connect"));
        var command = new MachineCommand("terminal", Wording.Get("Terminal.Summary")) { connect };
        command.SetAction((parsed, stop) => RunAsync(host, parsed.GetRequiredValue(connect)!, stop));
        return command;
    }

    private static async Task<int> RunAsync(VerbHost host, ControllerAddress address, CancellationToken stop)
    {
        await using var connection = MachineConnection.To(address, TimeProvider.System);
        await using var terminal = await connection.OpenTerminalAsync(TimeProvider.System, stop).ConfigureAwait(false);
        var screen = new TerminalScreen(host.Out, host.Interactive && Environment.GetEnvironmentVariable("NO_COLOR") is null or "");
        var conversation = new TerminalConversation(terminal, screen, TimeProvider.System);
        try
        {
            if (host.Interactive) screen.Show(new TerminalAnswer(TerminalAnswerKind.Help, Wording.Get("Terminal.Connected", terminal.Identity.Model, connection.Description)));
            await (host.Interactive ? conversation.RunKeysAsync(stop) : conversation.RunAsync(host.In, stop)).ConfigureAwait(false);
            return conversation.Code;
        }
        catch (OperationCanceledException) when (stop.IsCancellationRequested)
        {
            await terminal.StopAsync(MachineProfile.Default.ToolOutput, s_poll).ConfigureAwait(false);
            throw;
        }
    }
}
