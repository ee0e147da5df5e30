using System.Collections.Concurrent;
using Avalonia.Threading;
using Engraver.Workbench.Commands;

namespace Engraver.App.Desk;

/// <summary>Brings what a command session reports, from any thread, to the UI thread: one delivery for any number of changes.</summary>
/// <remarks>All members are for the UI thread, except <see cref="Post"/>.</remarks>
public sealed class DesktopNotifications : IDisposable
{
    private readonly CommandSession _session;
    private readonly DerivedModel _derived;
    private readonly MemoryReclaimer _released;
    private readonly ConcurrentQueue<CommandMessage> _messages = new();
    private int _posted;

    internal DesktopNotifications(CommandSession session, DerivedModel derived, MemoryReclaimer released)
    {
        (_session, _derived, _released) = (session, derived, released);
        Prompt = session.Prompt;
        derived.Posting += work => _ = PostWhenDoneAsync(work);
        session.MessageWritten += OnMessageWritten;
        session.Document.Changed += (_, _) => Post();
        session.Machine.Changed += (_, _) => Post();
        session.Machine.Alarms.Changed += (_, _) => Post();
        session.View.Changed += (_, _) => Post();
        session.Settings.Changed += (_, _) => Post();
        session.Progress.Changed += (_, _) => Post();
        session.Playback.Changed += (_, _) => Post();
        session.SequenceAnimation.Changed += (_, _) => Post();
        session.Derivation.Changed += (_, _) => Post();
        session.Derivation.Progress.Changed += (_, _) => Post();
        session.Certificates.Changed += (_, _) => Post();
        session.History.Changed += (_, _) => Post();
        session.Plots.Changed += (_, _) => Post();
    }

    /// <summary>New lines of the history.</summary>
    public event Action<IReadOnlyList<CommandMessage>>? MessagesWritten;

    /// <summary>Raised after prompt, document or machine have changed.</summary>
    public event Action? Changed;

    /// <summary>Raised when an input has failed by an exception that no command expects.</summary>
    public event Action<Exception>? Failed;

    /// <summary>The prompt, as of the last delivery.</summary>
    public PromptView Prompt { get; private set; }

    /// <summary>Adds a line of the window to the history, after the lines of the session before it.</summary>
    public void Write(MessageKind kind, string text)
    {
        _messages.Enqueue(new CommandMessage(kind, text));
        DeliverMessages();
    }

    /// <summary>Delivers everything now.</summary>
    public void Deliver()
    {
        Volatile.Write(ref _posted, 0);
        Prompt = _session.Prompt;
        DeliverMessages();
        _derived.Refresh();
        RaiseChanged();
        _released.OnDerivedChanged(_derived.Current);
    }

    public void Dispose() => _session.MessageWritten -= OnMessageWritten;

    /// <summary>Queues a delivery. Any number of calls leaves one delivery in the UI queue.</summary>
    internal void Post()
    {
        if (Interlocked.Exchange(ref _posted, 1) == 0) Dispatcher.UIThread.Post(Deliver, DispatcherPriority.Input);
    }

    internal void RaiseChanged() => Changed?.Invoke();

    /// <summary>Reports the failure of a task. Most callers do not await their input, so its failure must be reported here.</summary>
    internal Task<T> Watch<T>(Task<T> work)
    {
        _ = WatchAsync(work);
        return work;
    }

    private async Task PostWhenDoneAsync(Task work)
    {
        await WatchAsync(work);
        Post();
    }

    private async Task WatchAsync(Task work)
    {
        await work.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
        if (work.Exception is { } failure) Failed?.Invoke(failure.InnerException ?? failure);
    }

    private void OnMessageWritten(object? sender, CommandMessage message)
    {
        _messages.Enqueue(message);
        Post();
    }

    private void DeliverMessages()
    {
        var lines = new List<CommandMessage>();
        while (_messages.TryDequeue(out var message)) lines.Add(message);
        if (lines.Count > 0) MessagesWritten?.Invoke(lines);
    }
}
