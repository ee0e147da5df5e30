using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands;

/// <summary>One running command, which asks, is at work, or has ended.</summary>
internal sealed class CommandFrame : IDisposable
{
    private readonly CancellationTokenSource _cancel = new();
    private readonly CancellationToken _cancelled;
    private readonly TaskCompletionSource<InputResult> _ended = new();
    private TaskCompletionSource _asks = new();
    private volatile bool _isCancelled;

    public CommandFrame(CommandInfo info) => (Info, _cancelled) = (info, _cancel.Token);

    public CommandInfo Info { get; }

    /// <summary>It runs beside another command that is at work, and changes nothing that one may need.</summary>
    public bool IsBeside { get; init; }

    /// <summary>A dash was typed before its name: it asks at the command line, whatever windows there are.</summary>
    public bool HasNoDialog { get; init; }

    /// <summary>It was told to end.</summary>
    public bool IsCancelled => _isCancelled;

    /// <summary>What it waits for; null while it is at work.</summary>
    public PendingAsk? Pending { get; private set; }

    /// <summary>What the operator has picked for it so far, indices into the drawing's entities; null while nothing was asked for.</summary>
    public IReadOnlyList<int>? Picked { get; set; }

    /// <summary>It has asked something, be it answered or not.</summary>
    public bool HasAsked { get; private set; }

    /// <summary>How it ended; runs until then, also before it is started.</summary>
    public Task<InputResult> Ended => _ended.Task;

    public void Start(ICommand command, CommandContext context) => _ = EndAsync(RunAsync(command, context));

    /// <summary>Called by the command: waits for the operator.</summary>
    public async Task<Answer<T>> AskAsync<T>(ValuePrompt<T> prompt)
    {
        var pending = new PendingValue<T>(prompt);
        Await(pending);
        return await pending.Answer.ConfigureAwait(false);
    }

    /// <summary>Hands an input to the command that waits.</summary>
    /// <returns>Null when it was an answer, otherwise what is wanted instead.</returns>
    public string? Answer(string typed, Core.Geometry.Point2D lastPoint)
    {
        var pending = Pending ?? throw new InvalidOperationException("The command does not ask.");
        (Pending, _asks) = (null, new TaskCompletionSource());
        var isAnswered = false;
        try
        {
            var wanted = pending.TryAnswer(typed, lastPoint);
            isAnswered = wanted is null;
            return wanted;
        }
        finally
        {
            if (!isAnswered) Await(pending); // also where reading the answer failed: the question stands
        }
    }

    /// <summary>Waits until the command asks or has ended. What was told to end asks nothing any more.</summary>
    public async Task<InputResult> SettledAsync(CancellationToken cancellation)
    {
        await using var stop = cancellation.Register(Cancel).ConfigureAwait(false);
        await Task.WhenAny(_asks.Task, Ended).ConfigureAwait(false);
        return Ended.IsCompleted || IsCancelled ? await Ended.ConfigureAwait(false) : new InputResult.Asking();
    }

    public void Cancel()
    {
        _isCancelled = true;
        try
        {
            _cancel.Cancel();
        }
        catch (ObjectDisposedException)
        {
            return; // it has ended meanwhile: Esc comes from another thread
        }

        Pending?.Cancel();
    }

    public void Dispose() => _cancel.Dispose();

    /// <summary>From now on the question waits; where Esc came just before it (from another thread), it ends at once.</summary>
    private void Await(PendingAsk pending)
    {
        (Pending, HasAsked) = (pending, true);
        Interlocked.MemoryBarrier(); // the question is seen by Cancel, or Cancel is seen here
        if (IsCancelled) pending.Cancel();
        _asks.TrySetResult();
    }

    private async Task EndAsync(Task<InputResult> run)
    {
        await ((Task)run).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        _ended.SetFromTask(run);
    }

    private async Task<InputResult> RunAsync(ICommand command, CommandContext context)
    {
        try
        {
            await command.RunAsync(context, _cancelled).ConfigureAwait(false);
            return new InputResult.Done();
        }
        catch (CommandException failed)
        {
            return new InputResult.Failed(failed.Failure, failed.Message);
        }
        catch (SettingException unfit)
        {
            return new InputResult.Failed(CommandFailure.Usage, unfit.Message);
        }
        catch (MachineUnavailableException unavailable)
        {
            return new InputResult.Failed(CommandFailure.Refused, unavailable.Message);
        }
        catch (ControllerException link)
        {
            return new InputResult.Failed(CommandFailure.LinkLost, link.Message);
        }
        catch (Exception file) when (file is IOException or UnauthorizedAccessException)
        {
            return new InputResult.Failed(CommandFailure.Usage, SystemReason.WithPath(file) + ".");
        }
        catch (OperationCanceledException)
        {
            return new InputResult.Cancelled();
        }
        catch (Exception bug) // any exception is a bug here: it is reported, a job is stopped, and the desktop stays open
        {
            return context.Broken(bug);
        }
    }
}
