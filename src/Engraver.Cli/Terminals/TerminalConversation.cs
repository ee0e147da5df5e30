using Engraver.Core.Machines;

namespace Engraver.Cli.Terminals;

/// <summary>The session of <c>terminal</c>: reads lines from a pipe, or keys from the keyboard.</summary>
internal sealed class TerminalConversation(IMachineTerminal terminal, TerminalScreen screen, TimeProvider time)
{
    /// <summary>Polling interval of the keyboard and of the output of controller programs.</summary>
    private static readonly TimeSpan s_pollInterval = TimeSpan.FromMilliseconds(50);

    /// <summary>Done, or the exit code of the first line that the controller refused or this program withheld.</summary>
    public int Code { get; private set; } = ExitCode.Done;

    /// <summary>Answers every line up to the end of input or <c>quit</c>; remaining output of controller programs is shown at the end.</summary>
    public async Task RunAsync(TextReader lines, CancellationToken stop)
    {
        while (await NextAsync(lines, stop).ConfigureAwait(false) is { } line && !terminal.IsExitLine(line)) await AnswerAsync(line, stop).ConfigureAwait(false);
        foreach (var message in await terminal.PollAsync(stop).ConfigureAwait(false)) screen.Show(message);
    }

    /// <summary>The same with a line editor. A refused line does not change the exit code, because the operator sees the refusal.</summary>
    public async Task RunKeysAsync(CancellationToken stop)
    {
        while (await TypeAsync(stop).ConfigureAwait(false) is var line && !terminal.IsExitLine(line)) await AnswerAsync(line, stop).ConfigureAwait(false);
        Code = ExitCode.Done;
    }

    /// <summary>A console read cannot be cancelled, so the operator's stop does not wait for it.</summary>
    private static Task<string?> NextAsync(TextReader lines, CancellationToken stop) => Task.Run(lines.ReadLine, stop).WaitAsync(stop);

    private async Task AnswerAsync(string line, CancellationToken stop)
    {
        foreach (var answer in await terminal.ExecuteLineAsync(line, stop).ConfigureAwait(false))
        {
            screen.Show(answer);
            if (Code == ExitCode.Done) Code = CodeOf(answer.Kind);
        }
    }

    private static int CodeOf(TerminalAnswerKind kind) => kind switch
    {
        TerminalAnswerKind.Refusal => ExitCode.Refused,
        TerminalAnswerKind.Withheld => ExitCode.Usage,
        _ => ExitCode.Done,
    };

    private async Task<string> TypeAsync(CancellationToken stop)
    {
        var editor = new LineEditor(terminal.History);
        screen.ShowInput("", 0);
        while (true)
        {
            await AwaitKeyAsync(editor, stop).ConfigureAwait(false);
            if (editor.Press(Console.ReadKey(intercept: true))) break;
            screen.ShowInput(editor.Text, editor.Cursor);
        }

        screen.EndInput();
        return editor.Text;
    }

    private async Task AwaitKeyAsync(LineEditor editor, CancellationToken stop)
    {
        while (!Console.KeyAvailable)
        {
            await Task.Delay(s_pollInterval, time, stop).ConfigureAwait(false);
            var messages = await terminal.PollAsync(stop).ConfigureAwait(false);
            if (messages.Count == 0) continue;
            screen.HideInput();
            foreach (var message in messages) screen.Show(message);
            screen.ShowInput(editor.Text, editor.Cursor);
        }
    }
}
