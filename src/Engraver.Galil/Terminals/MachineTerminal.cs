using System.Collections.Concurrent;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Terminals;

/// <summary>A terminal for a controller, line by line: commands are sent, replies are shown, and the output of programs appears between them.</summary>
/// <remarks>Restores the state of the controller, like every session; numbers are printed in the format that was found.</remarks>
public sealed class MachineTerminal : IMachineTerminal
{
    private readonly ConcurrentQueue<string> _messages;
    private readonly List<string> _history = [];

    private MachineTerminal(ControllerSession session, ConcurrentQueue<string> messages)
    {
        Session = session;
        _messages = messages;
    }

    public ControllerSession Session { get; }

    public MachineIdentity Identity => Session.Identity;

    /// <summary>Lines as typed, oldest first.</summary>
    public IReadOnlyList<string> History => _history;

    /// <exception cref="ControllerException">The link could not be opened.</exception>
    public static async Task<MachineTerminal> OpenAsync(Func<CancellationToken, Task<IControllerLink>> openLink, TimeProvider time, CancellationToken cancellation)
    {
        var messages = new ConcurrentQueue<string>();
        var options = new SessionOptions
        {
            ReplyTimeout = CommandChannel.TransferTimeout, // burning takes seconds (galil-dmc.md A.6)
            SecondHandle = false, // text of programs then comes with the replies
            MessageReceived = messages.Enqueue,
        };
        var session = await ControllerSession.OpenAsync(openLink, options, time, cancellation).ConfigureAwait(false);
        if (session.Found.Wire.NumberFormatCommand is { } format) await session.Commands.SendAsync(format, cancellation).ConfigureAwait(false);
        return new MachineTerminal(session, messages);
    }

    /// <summary>A terminal on a session that another object owns: it must not be disposed.</summary>
    internal static MachineTerminal FromSession(ControllerSession session, ConcurrentQueue<string> messages) => new(session, messages);

    public bool IsExitLine(string line) => TerminalLine.Read(line) is TerminalLine.Quit;

    /// <summary>Executes one line: returns the output of programs so far, then the reply itself. The caller handles <see cref="TerminalLine.Quit"/>.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<IReadOnlyList<TerminalAnswer>> ExecuteLineAsync(string line, CancellationToken cancellation)
    {
        if (line.Trim().Length > 0) _history.Add(line.Trim());
        var answer = TerminalLine.Read(line) switch
        {
            TerminalLine.ToSend command => await SendAsync(command.Text, cancellation).ConfigureAwait(false),
            TerminalLine.Withheld withheld => new TerminalAnswer(TerminalAnswerKind.Withheld, withheld.Why),
            TerminalLine.Help help => new TerminalAnswer(TerminalAnswerKind.Help, TerminalHelp.About(help.About)),
            TerminalLine.History => new TerminalAnswer(TerminalAnswerKind.Help, string.Join('\n', _history)),
            _ => new TerminalAnswer(TerminalAnswerKind.Help, ""),
        };
        return [.. TakeMessages(), answer];
    }

    /// <summary>The output of programs since the last reply. Sends an empty command, because text only arrives with a reply.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<IReadOnlyList<TerminalAnswer>> PollAsync(CancellationToken cancellation)
    {
        await Session.Commands.SendAsync("", cancellation).ConfigureAwait(false);
        return [.. TakeMessages()];
    }

    /// <summary>Stops the machine for an operator who ends the program: the tool is switched off, every axis and plane brakes, and rest is awaited (ADR 4: in
    /// this order, in one line).</summary>
    public async Task StopAsync(int toolOutput, TimeSpan pollInterval)
    {
        var stop = new OperatorStop(Session, [toolOutput], [], Session.Identity.Letters);
        await stop.BrakeAtOnceAsync().ConfigureAwait(false);
        await stop.FinishAsync(pollInterval, CancellationToken.None).ConfigureAwait(false);
    }

    public ValueTask DisposeAsync() => Session.DisposeAsync();

    private async Task<TerminalAnswer> SendAsync(string command, CancellationToken cancellation)
    {
        var reply = command == "UL"
            ? await Session.Commands.UploadAsync(cancellation).ConfigureAwait(false)
            : await Session.Commands.SendAsync(command, cancellation).ConfigureAwait(false);
        return reply switch
        {
            Rejected refused => new TerminalAnswer(TerminalAnswerKind.Refusal, $"? {(int)refused.Code} {TextCatalogue.Fact(refused.Text)}{TcCodes.Hint(refused.Code)}{CaseHint(refused)}"),
            Accepted { Data.Length: > 0 } accepted => new TerminalAnswer(TerminalAnswerKind.Reply, accepted.Data),
            _ => new TerminalAnswer(TerminalAnswerKind.Reply, ":"),
        };
    }

    private static string CaseHint(Rejected refused) =>
        refused.Code == TcCode.UnrecognizedCommand && refused.Command.Length > 0 && char.IsAsciiLetterLower(refused.Command[0]) ? Wording.Get("MachineTerminal.CommandsUpperCase") : "";

    private IEnumerable<TerminalAnswer> TakeMessages()
    {
        while (_messages.TryDequeue(out var message)) yield return new TerminalAnswer(TerminalAnswerKind.Message, message);
    }
}
