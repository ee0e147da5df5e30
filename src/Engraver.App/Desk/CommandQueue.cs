using System.Runtime.CompilerServices;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;

namespace Engraver.App.Desk;

/// <summary>The inputs of the window on their way to the command session: one runs, on a thread of its own; others wait for it, or run beside the command at
/// work.</summary>
/// <remarks>
/// <para>What runs: inputs run one after the other.</para>
/// <para>What runs beside: while a command is at work, commands that may run beside it, and the answers to them, run one after the other too. An urgent one
/// (stop, hold, status) waits for nothing.</para>
/// <para>What waits: other typed inputs are kept and run when the command at work has ended properly (<see cref="TypeAheadBuffer"/>).</para>
/// <para>All members are for the UI thread.</para>
/// </remarks>
public sealed class CommandQueue : IAsyncDisposable
{
    private readonly CommandSession _session;
    private readonly DesktopNotifications _notifications;
    private readonly CancellationTokenSource _closing = new();
    private readonly TaskChain<InputResult> _inputs = new(new InputResult.Done());
    private readonly TaskChain<InputResult> _concurrent = new(new InputResult.Done());

    /// <summary>Typed inputs whose turn comes when nothing is on its way to run beside the command at work.</summary>
    private Task _typing = Task.CompletedTask;

    /// <summary>Changes when typed inputs that wait are dropped.</summary>
    private int _typingEpoch;

    /// <summary>Number of inputs that are kept until the command at work has ended.</summary>
    private int _kept;

    /// <summary>The input that runs; a failure of it does not matter when the window closes.</summary>
    private Task _running = Task.CompletedTask;

    internal CommandQueue(CommandSession session, DesktopNotifications notifications) => (_session, _notifications) = (session, notifications);

    /// <summary>An input runs.</summary>
    public bool IsBusy { get; private set; }

    /// <summary>Completes when all inputs so far have run.</summary>
    public Task Idle => _inputs.Last;

    /// <summary>Completes when the last Esc was passed on; the commands that it ends may take a little longer.</summary>
    public Task Cancelled { get; private set; } = Task.CompletedTask;

    /// <summary>Cancelled when the window closes.</summary>
    internal CancellationToken Closing => _closing.Token;

    /// <summary>A command is at work, which no change of drawing or machine may disturb.</summary>
    private bool IsAtWork => IsBusy && _session.IsBusy;

    /// <summary>Takes one input as typed. While a command is at work it runs beside it, where that is allowed; otherwise inputs wait for each other.</summary>
    public Task<InputResult> EnterAsync(string input)
    {
        if (!IsAtWork) return Enqueue(() => _session.EnterAsync(input, Closing));
        return _session.Concurrent.IsUrgent(input) ? _notifications.Watch(Task.Run(() => _session.EnterAsync(input, Closing))) : RunConcurrent(() => _session.EnterAsync(input, Closing));
    }

    /// <summary>Takes a point that was clicked.</summary>
    /// <param name="command">The only command that may get it; null: the one that asks.</param>
    public Task<InputResult> PointAsync(Point2D place, string? command = null)
    {
        if (IsAtWork) return RunConcurrent(() => _session.PointAsync(place, Closing));
        return Enqueue(() => command is null || _session.Prompt.Command == command ? _session.PointAsync(place, Closing) : Task.FromResult<InputResult>(new InputResult.Done()));
    }

    /// <summary>Takes one input from the command line. While a command is at work it runs beside it, or is kept and run when that command has ended properly
    /// (<see cref="TypeAheadBuffer"/>).</summary>
    public Task<InputResult> TypeAsync(string input)
    {
        if (IsAtWork && _session.Concurrent.IsUrgent(input)) return EnterAsync(input);
        return _concurrent.Last.IsCompleted && _typing.IsCompleted ? TypeNow(input) : TypeLater(input);
    }

    /// <summary>Takes pasted lines.</summary>
    public Task<InputResult> EnterLinesAsync(string lines) =>
        IsAtWork ? _notifications.Watch(Task.Run(() => _session.EnterLinesAsync(lines, Closing))) : Enqueue(() => _session.EnterLinesAsync(lines, Closing));

    /// <summary>Runs a command with its first answers, as a menu or a switch does: a command that asks is ended first, unless the new one may run inside
    /// it.</summary>
    public Task<InputResult> RunAsync(params string[] inputs)
    {
        if (!IsAtWork) return Enqueue(() => RunNowAsync(inputs));
        return _session.Concurrent.IsUrgent(inputs[0]) ? EnterAsync(inputs[0]) : RunConcurrent(() => RunConcurrentNowAsync(inputs));
    }

    /// <summary>Performs work that is not a command: in its turn, or concurrently with the running command.</summary>
    public Task<InputResult> PerformAsync(Func<InputResult> work)
    {
        Task<InputResult> Work() => Task.FromResult(work());
        return IsAtWork ? RunConcurrent(Work) : Enqueue(Work);
    }

    /// <summary>Answers the question for a file, unless it was answered or ended in the meantime. The dialog has already asked whether an existing file may be
    /// replaced.</summary>
    /// <param name="path">Null: Enter alone.</param>
    public Task<InputResult> AnswerFileAsync(FileRequest wanted, string? path) => Enqueue(async () =>
    {
        if (!ReferenceEquals(_session.Prompt.FileRequest, wanted)) return new InputResult.Cancelled();
        var result = await _session.EnterAsync(path is null ? "" : TypedFileName.Format(path), Closing).ConfigureAwait(false);
        return result is InputResult.AwaitingInput && _session.Prompt.ConfirmsReplacing ? await _session.EnterAsync("Yes", Closing).ConfigureAwait(false) : result;
    });

    /// <summary>Esc. Where nothing is typed, asked, at work or selected, it ends the search for the order, which keeps the best order found, or else the
    /// planning of the job.</summary>
    public Task CancelAsync()
    {
        _session.TypeAhead.Flush();
        if (!IsBusy && _session.Prompt.Command is null && _session.Document.Current.Selection.Count == 0) EndPlanning();
        return Cancelled = IsBusy ? Task.Run(_session.CancelAsync) : Enqueue(CancelNowAsync);
    }

    private void EndPlanning()
    {
        if (_session.Derivation.StopOrderSearch()) _notifications.Write(MessageKind.Note, Texts.Text.Get("Derivation.OrderKept"));
        else if (_session.Derivation.Cancel()) _notifications.Write(MessageKind.Warning, Texts.Text.Get("Derivation.PlanningCancelled"));
    }

    /// <summary>Ends the command beside the one at work, which continues, and drops typed inputs for it that have not reached it yet; Esc has held the
    /// job.</summary>
    public Task EndConcurrentAsync()
    {
        _typingEpoch++;
        return Cancelled = _typing = EndConcurrentAsync(_typing);
    }

    public async ValueTask DisposeAsync()
    {
        await _closing.CancelAsync().ConfigureAwait(false);
        await _running.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
    }

    /// <summary>Runs an input when its turn has come.</summary>
    private Task<InputResult> Enqueue(Func<Task<InputResult>> work) => _notifications.Watch(_inputs.Add(async () =>
    {
        IsBusy = true;
        _notifications.RaiseChanged();
        try
        {
            var running = Task.Run(work);
            _running = running;
            return await running;
        }
        finally
        {
            IsBusy = false;
            _notifications.Deliver();
        }
    }));

    /// <summary>Runs an input beside the command at work, after those before it.</summary>
    private Task<InputResult> RunConcurrent(Func<Task<InputResult>> work) => _notifications.Watch(_concurrent.Add(async () =>
    {
        try
        {
            return await Task.Run(work);
        }
        finally
        {
            _notifications.Deliver();
        }
    }));

    private Task<InputResult> TypeNow(string input)
    {
        if ((_kept == 0 || _session.Concurrent.HasPrompt) && (!IsAtWork || _session.Concurrent.Accepts(input))) return EnterAsync(input);
        if (_session.TypeAhead.RefusalOf(input) is { } refused)
        {
            _notifications.Write(MessageKind.Error, refused);
            return Task.FromResult<InputResult>(new InputResult.NotAccepted(refused));
        }

        _notifications.Write(MessageKind.Note, Texts.Text.Get("Command.Queued", input.Trim()));
        var (before, typedAt) = (_inputs.Last, _session.TypeAhead.Flushed);
        _kept++;
        return Enqueue(() => RunTypedAheadAsync(input, typedAt, before));
    }

    private async Task<InputResult> RunTypedAheadAsync(string input, int typedAt, Task<InputResult> before)
    {
        Interlocked.Decrement(ref _kept);
        return await _session.TypeAhead.EnterAsync(input, typedAt, before.IsCompletedSuccessfully ? await before.ConfigureAwait(false) : new InputResult.Cancelled(), Closing).ConfigureAwait(false);
    }

    /// <summary>An input that is typed while another is on its way beside the command at work may be an answer to it: its turn comes when that one is
    /// settled.</summary>
    private Task<InputResult> TypeLater(string input)
    {
        var typed = new TaskCompletionSource<Task<InputResult>>();
        _typing = TypeAfterAsync(_typing, input, typed);
        return typed.Task.Unwrap();
    }

    private async Task TypeAfterAsync(Task before, string input, TaskCompletionSource<Task<InputResult>> typed)
    {
        var epoch = _typingEpoch;
        await Settled(before);
        await Settled(_concurrent.Last);
        typed.SetResult(epoch == _typingEpoch ? TypeNow(input) : Task.FromResult<InputResult>(new InputResult.Cancelled()));
        await Settled(_concurrent.Last);
    }

    /// <summary>Ends it at once, and again when the input that was on its way to the session has started its command.</summary>
    private async Task EndConcurrentAsync(Task before)
    {
        var again = RunConcurrent(EndConcurrentNowAsync);
        await Task.Run(_session.Concurrent.EndAsync);
        await again;
        await Settled(before);
    }

    private async Task<InputResult> EndConcurrentNowAsync()
    {
        await _session.Concurrent.EndAsync().ConfigureAwait(false);
        return new InputResult.Cancelled();
    }

    private async Task<InputResult> CancelNowAsync()
    {
        await _session.CancelAsync().ConfigureAwait(false);
        return new InputResult.Cancelled();
    }

    private async Task<InputResult> RunNowAsync(string[] inputs)
    {
        var transparent = _session.Catalog.Find(inputs[0]) is { Info.IsTransparent: true };
        var inside = transparent && _session.Prompt.Command is not null;
        if (!inside && _session.Prompt.Command is not null) await _session.CancelAsync().ConfigureAwait(false);
        InputResult result = new InputResult.AwaitingInput();
        for (var at = 0; at < inputs.Length && result is InputResult.AwaitingInput; at++)
        {
            result = at == 0 && inside ? await _session.EnterNestedAsync(inputs[0], Closing).ConfigureAwait(false) : await _session.EnterAsync(inputs[at], Closing).ConfigureAwait(false);
        }

        if (result is InputResult.NotAccepted && inputs.Length > 1) await _session.CancelAsync().ConfigureAwait(false);
        return result;
    }

    /// <summary>The same beside the command at work; a command that asks beside it is ended first.</summary>
    private async Task<InputResult> RunConcurrentNowAsync(string[] inputs)
    {
        await _session.Concurrent.EndAsync().ConfigureAwait(false);
        InputResult result = new InputResult.AwaitingInput();
        for (var at = 0; at < inputs.Length && result is InputResult.AwaitingInput; at++) result = await _session.EnterAsync(inputs[at], Closing).ConfigureAwait(false);
        if (result is InputResult.NotAccepted && inputs.Length > 1) await _session.Concurrent.EndAsync().ConfigureAwait(false);
        return result;
    }

    /// <summary>Waits for the end of a task, also of one that has failed.</summary>
    private static ConfiguredTaskAwaitable Settled(Task task) => task.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
}
