using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands;

/// <summary>One command that is prompting, working or finished.</summary>
internal sealed class CommandFrame : IDisposable
{
    private readonly CancellationTokenSource _cancel = new();
    private readonly CancellationToken _cancelled;
    private readonly TaskCompletionSource<InputResult> _ended = new();
    private TaskCompletionSource _prompted = new();
    private volatile bool _isCancelled;

    public CommandFrame(CommandInfo info) => (Info, _cancelled) = (info, _cancel.Token);

    public CommandInfo Info { get; }

    /// <summary>It runs concurrently with another command and does not change what that one may use.</summary>
    public bool IsConcurrent { get; init; }

    /// <summary>A dash was typed before its name: it prompts at the command line instead of showing a dialog.</summary>
    public bool SuppressesDialogs { get; init; }

    /// <summary>Cancellation was requested.</summary>
    public bool IsCancelled => _isCancelled;

    /// <summary>The pending prompt; null while it is working.</summary>
    public PendingPrompt? Pending { get; private set; }

    /// <summary>The objects picked for it so far, indices into the drawing's entities; null before the first request.</summary>
    public IReadOnlyList<int>? Picked { get; set; }

    /// <summary>True after the first prompt, answered or not.</summary>
    public bool HasPrompted { get; private set; }

    /// <summary>The result; incomplete until the command has ended.</summary>
    public Task<InputResult> Ended => _ended.Task;

    public void Start(ICommand command, CommandContext context) => _ = EndAsync(RunAsync(command, context));

    /// <summary>Called by the command: waits for the operator.</summary>
    public async Task<Answer<T>> AskAsync<T>(ValuePrompt<T> prompt)
    {
        var pending = new PendingValue<T>(prompt);
        Await(pending);
        return await pending.Answer.ConfigureAwait(false);
    }

    /// <summary>Passes an input to the waiting command.</summary>
    /// <returns>Null if it was accepted, otherwise which input is expected.</returns>
    public string? Answer(string typed, Core.Geometry.Point2D lastPoint)
    {
        var pending = Pending ?? throw new InvalidOperationException("The command does not ask.");
        (Pending, _prompted) = (null, new TaskCompletionSource());
        var isAnswered = false;
        try
        {
            var wanted = pending.TryAnswer(typed, lastPoint);
            isAnswered = wanted is null;
            return wanted;
        }
        finally
        {
            if (!isAnswered) Await(pending); // Also if reading the answer failed: the prompt remains.
        }
    }

    /// <summary>Waits until the command prompts or has ended. A cancelled command does not prompt again.</summary>
    public async Task<InputResult> WaitForPromptOrEndAsync(CancellationToken cancellation)
    {
        await using var stop = cancellation.Register(Cancel).ConfigureAwait(false);
        await Task.WhenAny(_prompted.Task, Ended).ConfigureAwait(false);
        return Ended.IsCompleted || IsCancelled ? await Ended.ConfigureAwait(false) : new InputResult.AwaitingInput();
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
            return; // It has ended meanwhile: Esc comes from another thread.
        }

        Pending?.Cancel();
    }

    public void Dispose() => _cancel.Dispose();

    /// <summary>Sets the pending prompt; if Esc was pressed just before on another thread, the prompt is cancelled at once.</summary>
    private void Await(PendingPrompt pending)
    {
        (Pending, HasPrompted) = (pending, true);
        Interlocked.MemoryBarrier(); // Either Cancel sees the prompt or the cancellation is seen here.
        if (IsCancelled) pending.Cancel();
        _prompted.TrySetResult();
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
            return new InputResult.Failed(CommandFailure.Usage, SystemErrorText.WithPath(file) + ".");
        }
        catch (OperationCanceledException)
        {
            return new InputResult.Cancelled();
        }
        catch (Exception bug) // Any other exception is an internal error: it is reported, a job is stopped, and the desktop stays open.
        {
            return context.HandleInternalError(bug);
        }
    }
}
