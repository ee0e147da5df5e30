using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Commands;

/// <content>The commands that run beside one that is at work: what changes neither the drawing nor the machine, and what must always be heard.</content>
public sealed partial class CommandSession
{
    private CommandFrame? _aside;

    /// <summary>A job runs or something moves: nothing is kept to be run behind it.</summary>
    internal bool IsMachineAtWork => Machine.IsRunning || Machine.Status.State.IsMotion();

    /// <summary>A command beside the one at work waits for an answer.</summary>
    public bool AsksBeside => _aside is { Pending: not null };

    /// <summary>While a command is at work: this input is taken at once, beside it, for it is a command that is heard then or the answer to one.</summary>
    /// <remarks>While another drawing is brought, what is typed about view and drawing is meant for that one and waits.</remarks>
    public bool Hears(string input)
    {
        ArgumentNullException.ThrowIfNull(input);
        if (AsksBeside) return true;
        return Meant(input) is { Info: { IsHeardBeside: true } info } && (info.Group == CommandGroup.Machine || _frames.Top is not { Info.BringsDrawing: true });
    }

    /// <summary>This input must not wait for anything: it stops the machine, holds it, or says how it is.</summary>
    public bool IsUrgent(string input)
    {
        ArgumentNullException.ThrowIfNull(input);
        return Meant(input) is { Info: { HeardDuringJob: true, Transparent: true, Group: CommandGroup.Machine } };
    }

    /// <summary>Why this command is not run while the one at work is, a sentence; null when it is heard or not known.</summary>
    public string? WhyNotBeside(string input) => Meant(input) is { Info: { IsHeardBeside: false } info } ? ReasonFor(info) : null;

    /// <summary>Ends a command that asks or works beside the one at work; that one goes on. A command between two questions ends too: nothing is asked any
    /// more.</summary>
    /// <returns>True when it had asked something; false also when there is none.</returns>
    public async Task<bool> EndBesideAsync()
    {
        if (_aside is not { } aside || Interlocked.CompareExchange(ref _aside, null, aside) != aside) return false;
        aside.Cancel();
        await aside.Ended.ConfigureAwait(false);
        Interlocked.CompareExchange(ref _aside, null, aside); // its question may have come in the same moment
        aside.Dispose();
        return aside.HasAsked;
    }

    /// <summary>Takes an input while a command is at work: only a command that is heard then is run.</summary>
    /// <remarks>Answers may follow the command's name in the same input; what is still asked then is answered by the next input.</remarks>
    /// <param name="shown">The input as the history shows it; null: as it is.</param>
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
