namespace Engraver.Workbench.Commands;

/// <summary>The commands that run beside the one at work: those that change neither the drawing nor the machine, and those that must always be
/// taken.</summary>
public sealed class ConcurrentCommands
{
    private readonly CommandSession _session;
    private readonly FrameStack _frames;
    private CommandFrame? _frame;

    internal ConcurrentCommands(CommandSession session, FrameStack frames) => (_session, _frames) = (session, frames);

    /// <summary>A command beside the one at work waits for an answer.</summary>
    public bool HasPrompt => PromptingFrame is not null;

    /// <summary>The command beside the one at work that waits for an answer; null when none does.</summary>
    internal CommandFrame? PromptingFrame => _frame is { Pending: not null } frame ? frame : null;

    /// <summary>While a command is at work: this input is taken at once, beside it, because it is a command that may run then or the answer to one.</summary>
    /// <remarks>While another drawing is opened, input about view and drawing is meant for that drawing and waits.</remarks>
    public bool Accepts(string input)
    {
        ArgumentNullException.ThrowIfNull(input);
        if (HasPrompt) return true;
        return CommandOf(input) is { Info: { CanRunConcurrently: true } info } && (info.Group == CommandGroup.Machine || _frames.Top is not { Info.ReplacesDrawing: true });
    }

    /// <summary>This input must not wait for anything: it stops the machine, holds it, or shows its status.</summary>
    public bool IsUrgent(string input)
    {
        ArgumentNullException.ThrowIfNull(input);
        return CommandOf(input) is { Info: { IsAllowedDuringJob: true, IsTransparent: true, Group: CommandGroup.Machine } };
    }

    /// <summary>Why this command may not run beside the one at work, a sentence; null when it may or is not known.</summary>
    public string? WhyNot(string input) => CommandOf(input) is { Info: { CanRunConcurrently: false } info } ? ReasonFor(info) : null;

    /// <summary>Ends a command that asks or works beside the one at work, which continues. A command between two questions ends too: nothing is asked any
    /// more.</summary>
    /// <returns>True when it had asked something; false also when there is none.</returns>
    public async Task<bool> EndAsync()
    {
        if (_frame is not { } frame || Interlocked.CompareExchange(ref _frame, null, frame) != frame) return false;
        frame.Cancel();
        await frame.Ended.ConfigureAwait(false);
        Interlocked.CompareExchange(ref _frame, null, frame); // its question may have come in the same moment
        frame.Dispose();
        return frame.HasPrompted;
    }

    /// <summary>Takes an input while a command is at work: only a command that may run beside it is run.</summary>
    /// <remarks>Answers may follow the command's name in the same input; what is still asked then is answered by the next input.</remarks>
    /// <param name="shown">The input as the history shows it; null: as it is.</param>
    internal async Task<InputResult> EnterAsync(string input, CancellationToken cancellation, string? shown = null)
    {
        if (PromptingFrame is { } asking)
        {
            if (!IsUrgent(input)) return await AnswerAsync(asking, input, shown ?? input, cancellation).ConfigureAwait(false);
            await EndAsync().ConfigureAwait(false);
        }

        var words = input.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        if (words.Length == 0) return new InputResult.NotAccepted(Wording.Get("TypeAheadBuffer.EnterAlone"));
        if (_session.Find(words[0]) is not { } command) return new InputResult.NotAccepted(Wording.Get("CommandSession.UnknownCommand", input));
        if (!command.Info.CanRunConcurrently) return new InputResult.NotAccepted(ReasonFor(command.Info));
        return await RunAsync(command, words, cancellation).ConfigureAwait(false);
    }

    private async Task<InputResult> RunAsync(ICommand command, string[] words, CancellationToken cancellation)
    {
        if (!IsUrgent(words[0])) _session.Echo(words[0]);
        var frame = new CommandFrame(command.Info) { IsConcurrent = true, SuppressesDialogs = CommandPrefix.HasDash(words[0]) };
        Interlocked.CompareExchange(ref _frame, frame, null);
        frame.Start(command, new CommandContext(_session, frame));
        var result = await CompleteAsync(frame, cancellation).ConfigureAwait(false);
        foreach (var word in words.Skip(1))
        {
            if (result is not InputResult.AwaitingInput) return result;
            result = await AnswerAsync(frame, word, word, cancellation).ConfigureAwait(false);
        }

        return result;
    }

    private async Task<InputResult> AnswerAsync(CommandFrame frame, string answer, string shown, CancellationToken cancellation)
    {
        _session.Echo(shown);
        return frame.Answer(answer, _session.LastPoint) is { } wanted ? new InputResult.NotAccepted(wanted) : await CompleteAsync(frame, cancellation).ConfigureAwait(false);
    }

    private async Task<InputResult> CompleteAsync(CommandFrame frame, CancellationToken cancellation)
    {
        var result = await frame.WaitForPromptOrEndAsync(cancellation).ConfigureAwait(false);
        if (result is InputResult.AwaitingInput)
        {
            if (Interlocked.Exchange(ref _frame, frame) is { } other && other != frame) other.Cancel();
            if (!frame.IsCancelled) return result;
            result = await frame.Ended.ConfigureAwait(false);
        }

        Interlocked.CompareExchange(ref _frame, null, frame);
        frame.Dispose();
        return result;
    }

    private string ReasonFor(CommandInfo info)
    {
        var work = _session.RunningCommand ?? Wording.Get("CommandSession.AnotherCommand");
        return Wording.Get(info.Group == CommandGroup.Machine || info.StartsMotion ? "CommandSession.MachineInUse" : "CommandSession.DrawingInUse", info.Name, work);
    }

    private ICommand? CommandOf(string input) => input.Split(' ', StringSplitOptions.RemoveEmptyEntries) is [var word, ..] ? _session.Find(word) : null;
}
