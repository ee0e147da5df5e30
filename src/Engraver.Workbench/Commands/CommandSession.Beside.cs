using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Commands;

/// <content>Commands that run concurrently with another one: those that change neither drawing nor machine, and those that must always work, such as
/// CNCSTOP.</content>
public sealed partial class CommandSession
{
    private CommandFrame? _aside;

    /// <summary>A job runs or the machine moves: inputs are not queued.</summary>
    internal bool IsMachineAtWork => Machine.IsRunning || Machine.Status.State.IsMotion();

    /// <summary>A concurrent command waits for an answer.</summary>
    public bool AsksBeside => _aside is { Pending: not null };

    /// <summary>While a command works: true if this input is a concurrent command or the answer to one, and is processed at once.</summary>
    /// <remarks>While another drawing is being opened, inputs about view and drawing apply to the new drawing and are queued.</remarks>
    public bool Hears(string input)
    {
        ArgumentNullException.ThrowIfNull(input);
        if (AsksBeside) return true;
        return Meant(input) is { Info: { IsHeardBeside: true } info } && (info.Group == CommandGroup.Machine || _frames.Top is not { Info.BringsDrawing: true });
    }

    /// <summary>This input must be processed at once: it stops the machine, holds it or shows its state.</summary>
    public bool IsUrgent(string input)
    {
        ArgumentNullException.ThrowIfNull(input);
        return Meant(input) is { Info: { HeardDuringJob: true, Transparent: true, Group: CommandGroup.Machine } };
    }

    /// <summary>Why this command cannot run concurrently, a sentence; null if it can or is unknown.</summary>
    public string? WhyNotBeside(string input) => Meant(input) is { Info: { IsHeardBeside: false } info } ? ReasonFor(info) : null;

    /// <summary>Ends a concurrent command; the other one continues. A command between two prompts ends too and does not prompt again.</summary>
    /// <returns>True if it had prompted; false also if there is none.</returns>
    public async Task<bool> EndBesideAsync()
    {
        if (_aside is not { } aside || Interlocked.CompareExchange(ref _aside, null, aside) != aside) return false;
        aside.Cancel();
        await aside.Ended.ConfigureAwait(false);
        Interlocked.CompareExchange(ref _aside, null, aside); // Its prompt may have appeared at the same moment.
        aside.Dispose();
        return aside.HasAsked;
    }

    /// <summary>Processes an input while a command works: only commands that may run concurrently are started.</summary>
    /// <remarks>Answers may follow the command's name in the same input; further prompts are answered by the next inputs.</remarks>
    /// <param name="shown">The input as shown in the history; null: unchanged.</param>
    private async Task<InputResult> HearAsync(string input, CancellationToken cancellation, string? shown = null)
    {
        if (_aside is { Pending: { } asks } asking)
        {
            if (!IsUrgent(input)) return await AnswerAsideAsync(asking, input, shown ?? input, cancellation).ConfigureAwait(false);
            await EndBesideAsync().ConfigureAwait(false);
        }

        var words = input.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        if (words.Length == 0) return new InputResult.NotUnderstood(Wording.Get("TypedAhead.EnterAlone"));
        if (Find(words[0]) is not { } command) return new InputResult.NotUnderstood(Wording.Get("CommandSession.UnknownCommand", input));
        if (!command.Info.IsHeardBeside) return new InputResult.NotUnderstood(ReasonFor(command.Info));
        return await HearAsync(command, words, cancellation).ConfigureAwait(false);
    }

    private async Task<InputResult> HearAsync(ICommand command, string[] words, CancellationToken cancellation)
    {
        if (!IsUrgent(words[0])) Echo(words[0]);
        var frame = new CommandFrame(command.Info) { IsBeside = true, HasNoDialog = CommandWord.HasDash(words[0]) };
        Interlocked.CompareExchange(ref _aside, frame, null);
        frame.Start(command, new CommandContext(this, frame));
        var result = await SettleAsideAsync(frame, cancellation).ConfigureAwait(false);
        foreach (var word in words.Skip(1))
        {
            if (result is not InputResult.Asking) return result;
            result = await AnswerAsideAsync(frame, word, word, cancellation).ConfigureAwait(false);
        }

        return result;
    }

    private async Task<InputResult> AnswerAsideAsync(CommandFrame frame, string answer, string shown, CancellationToken cancellation)
    {
        Echo(shown);
        return frame.Answer(answer, LastPoint) is { } wanted ? new InputResult.NotUnderstood(wanted) : await SettleAsideAsync(frame, cancellation).ConfigureAwait(false);
    }

    private async Task<InputResult> SettleAsideAsync(CommandFrame frame, CancellationToken cancellation)
    {
        var result = await frame.SettledAsync(cancellation).ConfigureAwait(false);
        if (result is InputResult.Asking)
        {
            if (Interlocked.Exchange(ref _aside, frame) is { } other && other != frame) other.Cancel();
            if (!frame.IsCancelled) return result;
            result = await frame.Ended.ConfigureAwait(false);
        }

        Interlocked.CompareExchange(ref _aside, null, frame);
        frame.Dispose();
        return result;
    }

    private string ReasonFor(CommandInfo info)
    {
        var work = Running ?? Wording.Get("CommandSession.AnotherCommand");
        return Wording.Get(info.Group == CommandGroup.Machine || info.StartsMotion ? "CommandSession.MachineInUse" : "CommandSession.DrawingInUse", info.Name, work);
    }

    private ICommand? Meant(string input) => input.Split(' ', StringSplitOptions.RemoveEmptyEntries) is [var word, ..] ? Find(word) : null;
}
