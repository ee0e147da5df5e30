using System.Collections.Concurrent;
using Avalonia.Threading;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Views;

namespace Engraver.App.Desk;

/// <summary>Connects the window with the command session: inputs go to it one after the other on a thread of their own, its events come back on the UI
/// thread. Decides nothing.</summary>
/// <remarks>All members are for the UI thread, <see cref="StopNow"/> for any.</remarks>
public sealed class DesktopModel : IAsyncDisposable
{
    /// <summary>A finding is shown with this many times its size around it.</summary>
    private const double RoomAround = 4.0;

    /// <summary>... and never nearer than this part of the drawing.</summary>
    private const double LeastPart = 0.02;

    private readonly ConcurrentQueue<CommandMessage> _said = new();
    private readonly CancellationTokenSource _closing = new();
    private Task<InputResult> _feeding = Task.FromResult<InputResult>(new InputResult.Done());
    private Task _hearing = Task.CompletedTask;
    private Task _typing = Task.CompletedTask;
    private int _kept;
    private int _typedFor;
    private Task _working = Task.CompletedTask;
    private int _posted;
    private readonly ReleasedMemory _released;

    public DesktopModel(CommandSession session, TimeProvider time)
    {
        (Session, Time) = (session, time);
        Prompt = session.Prompt;
        Derived = new DerivedModel(session);
        _released = ReleasedMemory.OfDesktop(() => IsMoving);
        Derived.Posting += work => _ = TellWhenDoneAsync(work);
        session.Said += OnSaid;
        session.Document.Changed += (_, _) => Post();
        session.Machine.Changed += (_, _) => Post();
        session.Machine.Alarms.Changed += (_, _) => Post();
        session.View.Changed += (_, _) => Post();
        session.Settings.Changed += (_, _) => Post();
        session.Progress.Changed += (_, _) => Post();
        session.Playback.Changed += (_, _) => Post();
        session.Walk.Changed += (_, _) => Post();
        session.Derivation.Changed += (_, _) => Post();
        session.Derivation.Progress.Changed += (_, _) => Post();
        session.Certificates.Changed += (_, _) => Post();
        session.History.Changed += (_, _) => Post();
        session.Derivation.KeepsUp = true;
    }

    /// <summary>Lines of the history that are new.</summary>
    public event Action<IReadOnlyList<CommandMessage>>? Said;

    /// <summary>Raised after prompt, document or machine have changed.</summary>
    public event Action? Changed;

    /// <summary>Raised when an input has failed by an exception that no command expects.</summary>
    public event Action<Exception>? Failed;

    public CommandSession Session { get; }

    public TimeProvider Time { get; }

    /// <summary>Nothing of a large drawing that is gone waits to be given back to the computer.</summary>
    internal bool IsMemoryReleased => _released.IsDone;

    /// <summary>What follows from the document.</summary>
    public DerivedModel Derived { get; }

    /// <summary>The prompt, as of the last change.</summary>
    public PromptView Prompt { get; private set; }

    /// <summary>True while an input is being worked on.</summary>
    public bool IsBusy { get; private set; }

    /// <summary>True while a command is at work, which nothing that changes drawing or machine may disturb.</summary>
    private bool IsAtWork => IsBusy && Session.IsBusy;

    /// <summary>The place of the drawing that a click would give now; null while the cursor is not on the canvas.</summary>
    public Point2D? Cursor { get; set; }

    /// <summary>True while a job runs or anything of the machine moves.</summary>
    public bool IsMoving => Moves(Session.Machine);

    /// <summary>Completes when all inputs so far have been worked on.</summary>
    public Task Idle => _feeding;

    /// <summary>True while a job runs or anything moves; from any thread.</summary>
    public static bool Moves(MachineSession machine) => machine.IsRunning || machine.Status.State.IsMotion();

    /// <summary>Waits until everything that was entered is through and what follows from the document is computed and delivered.</summary>
    public async Task SettleAsync()
    {
        await _feeding;
        try
        {
            if (!Session.Derivation.IsGivenUp) await Session.Derivation.ForCurrentAsync(_closing.Token);
        }
        catch (OperationCanceledException)
        {
            // the document changed meanwhile; Changed is raised when its derivation is there
        }

        Deliver();
        await Derived.Written.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
        Deliver();
    }

    /// <summary>Takes one input as typed. While a command is at work it is heard beside it, where the command is one of those; otherwise inputs wait for
    /// each other.</summary>
    public Task<InputResult> EnterAsync(string input)
    {
        if (!IsAtWork) return Enqueue(() => Session.EnterAsync(input, _closing.Token));
        return Session.IsUrgent(input) ? Watched(Task.Run(() => Session.EnterAsync(input, _closing.Token))) : Hear(() => Session.EnterAsync(input, _closing.Token));
    }

    /// <summary>Takes a place that was pointed at.</summary>
    /// <param name="command">The only command that is to have it; null: whichever asks.</param>
    public Task<InputResult> PointAsync(Point2D place, string? command = null)
    {
        if (IsAtWork) return Hear(() => Session.PointAsync(place, _closing.Token));
        return Enqueue(() => command is null || Session.Prompt.Command == command ? Session.PointAsync(place, _closing.Token) : Task.FromResult<InputResult>(new InputResult.Done()));
    }

    /// <summary>Takes one input from the command line. While a command is at work it is heard beside it, or kept and run when that has ended as it should
    /// (<see cref="TypedAhead"/>).</summary>
    public Task<InputResult> TypeAsync(string input)
    {
        if (IsAtWork && Session.IsUrgent(input)) return EnterAsync(input);
        return _hearing.IsCompleted && _typing.IsCompleted ? TypeNow(input) : TypeLater(input);
    }

    private Task<InputResult> TypeNow(string input)
    {
        if ((_kept == 0 || Session.AsksBeside) && (!IsAtWork || Session.Hears(input))) return EnterAsync(input);
        if (Session.Ahead.WhyNot(input) is { } refused)
        {
            Tell(MessageKind.Error, refused);
            return Task.FromResult<InputResult>(new InputResult.NotUnderstood(refused));
        }

        Tell(MessageKind.Note, Texts.Text.Get("Command.Queued", input.Trim()));
        var (before, typedAt) = (_feeding, Session.Ahead.Flushed);
        _kept++;
        return Enqueue(() => KeptAsync(input, typedAt, before));
    }

    /// <summary>Takes pasted lines.</summary>
    public Task<InputResult> EnterLinesAsync(string lines) =>
        IsBusy && Session.IsBusy ? Watched(Task.Run(() => Session.EnterLinesAsync(lines, _closing.Token))) : Enqueue(() => Session.EnterLinesAsync(lines, _closing.Token));

    /// <summary>A line of the window itself in the history, behind what the session has said before it.</summary>
    public void Tell(MessageKind kind, string text)
    {
        _said.Enqueue(new CommandMessage(kind, text));
        DeliverSaid();
    }

    /// <summary>Runs a command with its first answers, as a menu or a switch does: what asks is ended first, unless the command may run inside it.</summary>
    public Task<InputResult> RunAsync(params string[] inputs)
    {
        if (!IsAtWork) return Enqueue(() => RunNowAsync(inputs));
        return Session.IsUrgent(inputs[0]) ? EnterAsync(inputs[0]) : Hear(() => RunBesideAsync(inputs));
    }

    /// <summary>Answers the question for a file, unless it was answered or ended meanwhile. Whether a file that is there may be replaced was asked
    /// before.</summary>
    /// <param name="path">Null: Enter alone.</param>
    public Task<InputResult> AnswerFileAsync(FileWanted wanted, string? path) => Enqueue(async () =>
    {
        if (!ReferenceEquals(Session.Prompt.File, wanted)) return new InputResult.Cancelled();
        var result = await Session.EnterAsync(path is null ? "" : TypedFileName.Write(path), _closing.Token).ConfigureAwait(false);
        return result is InputResult.Asking && Session.Prompt.Replaces ? await Session.EnterAsync("Yes", _closing.Token).ConfigureAwait(false) : result;
    });

    /// <summary>START: runs what is armed.</summary>
    public Task<InputResult> StartArmedAsync() => RunAsync("CNCRUN");

    /// <summary>Selects without a command, as a click on the canvas does: what is found is added, or taken out.</summary>
    public Task SelectAsync(Func<Drawing, IReadOnlyList<int>> find, bool remove) =>
        IsAtWork ? Hear(() => Task.FromResult<InputResult>(SelectNow(find, remove))) : Enqueue(() => Task.FromResult<InputResult>(SelectNow(find, remove)));

    /// <summary>Brings the place of a finding into the middle of the canvas, near enough to see it.</summary>
    public void ShowPlaceOf(Diagnostic finding)
    {
        if (Session.Document.Current.Drawing is not { } drawing) return;
        if (finding.Place is { } place)
        {
            var whole = Session.View.ExtentsOf(drawing);
            var part = LeastPart * Math.Max(whole.Width, whole.Height);
            Session.View.FocusOn(new ViewFocus(drawing.Scale.ToDrawing(place), finding), part > 0.0 ? part : null);
            return;
        }

        if (finding.Source.Handle is not { } handle || drawing.IndexOfHandle(handle) is not { } entity) return;
        var box = DrawingExtents.Measure(drawing, [entity]);
        if (box.IsEmpty) return;
        var everything = Session.View.ExtentsOf(drawing);
        var height = Math.Max(RoomAround * Math.Max(box.Width, box.Height), LeastPart * Math.Max(everything.Width, everything.Height));
        Session.View.FocusOn(new ViewFocus(new Point2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0), finding), height > 0.0 ? height : null);
    }

    /// <summary>Completes when the last Esc was passed on; what it ends may take a little longer.</summary>
    public Task Cancelled { get; private set; } = Task.CompletedTask;

    /// <summary>Esc. Where nothing is typed, asked, at work or selected, it ends the planning of the job.</summary>
    public Task CancelAsync()
    {
        Session.Ahead.Flush();
        if (!IsBusy && Session.Prompt.Command is null && Session.Document.Current.Selection.Count == 0 && Session.Derivation.GiveUp()) Tell(MessageKind.Warning, Texts.Text.Get("Derivation.PlanningCancelled"));
        return Cancelled = IsBusy ? Task.Run(Session.CancelAsync) : Enqueue(CancelNowAsync);
    }

    /// <summary>Ends what asks or works beside the command at work, which goes on, and forgets what was typed for it and has not come to it yet; Esc has
    /// held the job.</summary>
    public Task EndBesideAsync()
    {
        _typedFor++;
        return Cancelled = _typing = EndAfterAsync(_typing);
    }

    /// <summary>The operator's stop. Straight to the machine, from any thread; waits for nothing.</summary>
    public void StopNow()
    {
        Session.Machine.Stop();
        Session.Ahead.Flush();
    }

    /// <summary>Holds the job under way. From any thread; waits for nothing.</summary>
    public void HoldNow() => Session.Machine.HoldJob();

    /// <summary>Changes the operator's feed by a part of the programmed one.</summary>
    public void OverrideBy(double part) => Session.Machine.Override(Math.Round(Session.Machine.Status.FeedRatio + part, 2), null);

    /// <summary>The same for rapids.</summary>
    public void OverrideRapidsBy(double part) => Session.Machine.Override(null, Math.Round(Session.Machine.Status.RapidRatio + part, 2));

    public async ValueTask DisposeAsync()
    {
        Session.Said -= OnSaid;
        await _closing.CancelAsync().ConfigureAwait(false);
        await _working.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        await Session.DisposeAsync().ConfigureAwait(false);
    }

    private async Task<InputResult> KeptAsync(string input, int typedAt, Task<InputResult> before)
    {
        Interlocked.Decrement(ref _kept);
        return await Session.Ahead.EnterAsync(input, typedAt, before.IsCompletedSuccessfully ? await before.ConfigureAwait(false) : new InputResult.Cancelled(), _closing.Token).ConfigureAwait(false);
    }

    private async Task<InputResult> RunNowAsync(string[] inputs)
    {
        var transparent = Session.Catalog.Find(inputs[0]) is { Info.Transparent: true };
        var inside = transparent && Session.Prompt.Command is not null;
        if (!inside && Session.Prompt.Command is not null) await Session.CancelAsync().ConfigureAwait(false);
        InputResult result = new InputResult.Asking();
        for (var at = 0; at < inputs.Length && result is InputResult.Asking; at++)
        {
            result = at == 0 && inside ? await Session.EnterInsideAsync(inputs[0], _closing.Token).ConfigureAwait(false) : await Session.EnterAsync(inputs[at], _closing.Token).ConfigureAwait(false);
        }

        if (result is InputResult.NotUnderstood && inputs.Length > 1) await Session.CancelAsync().ConfigureAwait(false);
        return result;
    }

    /// <summary>The same beside the command at work; what asks beside it is ended first.</summary>
    private async Task<InputResult> RunBesideAsync(string[] inputs)
    {
        await Session.EndBesideAsync().ConfigureAwait(false);
        InputResult result = new InputResult.Asking();
        for (var at = 0; at < inputs.Length && result is InputResult.Asking; at++) result = await Session.EnterAsync(inputs[at], _closing.Token).ConfigureAwait(false);
        if (result is InputResult.NotUnderstood && inputs.Length > 1) await Session.EndBesideAsync().ConfigureAwait(false);
        return result;
    }

    private async Task<InputResult> CancelNowAsync()
    {
        await Session.CancelAsync().ConfigureAwait(false);
        return new InputResult.Cancelled();
    }

    private InputResult.Done SelectNow(Func<Drawing, IReadOnlyList<int>> find, bool remove)
    {
        var state = Session.Document.Current;
        if (state.Drawing is not { } drawing || Session.Prompt.Command is not null) return new InputResult.Done();
        var found = find(drawing);
        Session.Document.SelectIn(drawing, now =>
        {
            var known = (remove ? found : now.Selection).ToHashSet();
            return remove ? [.. now.Selection.Where(entity => !known.Contains(entity))] : [.. now.Selection, .. found.Where(entity => !known.Contains(entity))];
        });
        return new InputResult.Done();
    }

    /// <summary>Runs one input after the other beside the command at work.</summary>
    private Task<InputResult> Hear(Func<Task<InputResult>> work)
    {
        var after = HearAfterAsync(_hearing, work);
        _hearing = after;
        return Watched(after);
    }

    private async Task<InputResult> HearAfterAsync(Task before, Func<Task<InputResult>> work)
    {
        await before.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
        try
        {
            return await Task.Run(work);
        }
        finally
        {
            Deliver();
        }
    }

    /// <summary>What is typed while something is heard beside the command at work may be an answer to it: its turn comes when that is settled.</summary>
    private Task<InputResult> TypeLater(string input)
    {
        var typed = new TaskCompletionSource<Task<InputResult>>();
        _typing = TypeAfterAsync(_typing, input, typed);
        return typed.Task.Unwrap();
    }

    private async Task TypeAfterAsync(Task before, string input, TaskCompletionSource<Task<InputResult>> typed)
    {
        var typedFor = _typedFor;
        await before.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
        await _hearing.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
        typed.SetResult(typedFor == _typedFor ? TypeNow(input) : Task.FromResult<InputResult>(new InputResult.Cancelled()));
        await _hearing.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
    }

    /// <summary>At once, and again when the input that was on its way to the session has begun its command; before what is clicked behind Esc.</summary>
    private async Task EndAfterAsync(Task before)
    {
        var again = Hear(EndBesideNowAsync);
        await Task.Run(Session.EndBesideAsync);
        await again;
        await before.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
    }

    private async Task<InputResult> EndBesideNowAsync()
    {
        await Session.EndBesideAsync().ConfigureAwait(false);
        return new InputResult.Cancelled();
    }

    private Task<InputResult> Enqueue(Func<Task<InputResult>> work)
    {
        var after = AfterAsync(_feeding, work);
        _feeding = after;
        return Watched(after);
    }

    /// <summary>Most callers do not wait for what they ask: a failure must be heard all the same.</summary>
    private Task<InputResult> Watched(Task<InputResult> work)
    {
        _ = WatchAsync(work);
        return work;
    }

    /// <summary>What a page waits for is there, or has failed.</summary>
    private async Task TellWhenDoneAsync(Task work)
    {
        await WatchAsync(work);
        Post();
    }

    private async Task WatchAsync(Task work)
    {
        await work.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
        if (work.Exception is { } failure) Failed?.Invoke(failure.InnerException ?? failure);
    }

    private async Task<InputResult> AfterAsync(Task before, Func<Task<InputResult>> work)
    {
        await before.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
        IsBusy = true;
        Changed?.Invoke();
        try
        {
            var working = Task.Run(work);
            _working = working;
            return await working;
        }
        finally
        {
            IsBusy = false;
            Deliver();
        }
    }

    private void OnSaid(object? sender, CommandMessage message)
    {
        _said.Enqueue(message);
        Post();
    }

    /// <summary>However often the session calls, one delivery waits in the UI queue.</summary>
    private void Post()
    {
        if (Interlocked.Exchange(ref _posted, 1) == 0) Dispatcher.UIThread.Post(Deliver, DispatcherPriority.Input);
    }

    private void Deliver()
    {
        Volatile.Write(ref _posted, 0);
        Prompt = Session.Prompt;
        DeliverSaid();
        Derived.Look();
        Changed?.Invoke();
        _released.Look(Derived.Current);
    }

    private void DeliverSaid()
    {
        var lines = new List<CommandMessage>();
        while (_said.TryDequeue(out var message)) lines.Add(message);
        if (lines.Count > 0) Said?.Invoke(lines);
    }
}
