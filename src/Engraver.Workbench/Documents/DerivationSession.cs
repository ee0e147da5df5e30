using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>Computes the derived document (<see cref="DerivedDocument"/>) in the background, once for each state. A computation is cancelled when the state
/// changes before it is done.</summary>
/// <remarks>Any thread. Without <see cref="IsAutomatic"/> nothing is computed until requested.</remarks>
public sealed class DerivationSession : IDisposable
{
    private readonly Lock _guard = new();
    private readonly DocumentSession _document;
    private readonly PlateSession _plates;
    private Derivation? _running;
    private ExecutionStrategy? _strategy;
    private SerialAddress? _line;
    private bool _isAutomatic;
    private DerivedDocument? _cancelledWork;

    public DerivationSession(DocumentSession document, PlateSession plates)
    {
        ArgumentNullException.ThrowIfNull(document);
        ArgumentNullException.ThrowIfNull(plates);
        (_document, _plates) = (document, plates);
        _document.Changed += OnDocumentChanged;
        _plates.Changed += OnDocumentChanged;
    }

    /// <summary>Raised after <see cref="Current"/> has changed, on a thread of the pool.</summary>
    public event EventHandler? Changed;

    /// <summary>The stage being computed; null while idle. Its event is raised on a thread of the pool.</summary>
    public DerivationProgress Progress { get; } = new();

    /// <summary>The computation for the current document was cancelled by <see cref="Cancel"/>: it restarts when the document changes or on request.</summary>
    public bool IsCancelled => _cancelledWork is { } wanted && IsOf(wanted, _document.Current, Strategy, _line);

    /// <summary>The last completed result; it may be older than the document.</summary>
    public DerivedDocument Current { get; private set; } = DerivedDocument.Nothing;

    /// <summary>True if <see cref="Current"/> belongs to the current document.</summary>
    public bool IsCurrent => IsOf(Current, _document.Current, Strategy, Line);

    /// <summary>The execution strategy that jobs are prepared for: the one that was set if the driver of the machine profile has it, otherwise the driver's
    /// default.</summary>
    public ExecutionStrategy Strategy
    {
        get => StrategyFor(_document.Current);
        set
        {
            _strategy = value;
            if (_isAutomatic) _ = ForCurrentAsync(CancellationToken.None);
        }
    }

    /// <summary>The serial line of the connected machine; null for none. The plan of a job depends on it.</summary>
    public SerialAddress? Line
    {
        get => _line;
        set
        {
            if (_line == value) return;
            _line = value;
            if (_isAutomatic) _ = ForCurrentAsync(CancellationToken.None);
        }
    }

    /// <summary>True: every new state is computed at once, as needed by a desktop.</summary>
    public bool IsAutomatic
    {
        get => _isAutomatic;
        set
        {
            _isAutomatic = value;
            if (value) _ = ForCurrentAsync(CancellationToken.None);
        }
    }

    /// <summary>Task to await before computing a document without earlier results: a window shows a drawing before planning it. Its result is ignored. Null:
    /// none. Called under a lock, so it must not block.</summary>
    public Func<DocumentState, Task>? Prerequisite { get; set; }

    /// <summary>The derived document of the current state. Does not compute on the caller's thread.</summary>
    /// <param name="cancellation">Ends the waiting; the computation continues for other callers.</param>
    /// <exception cref="OperationCanceledException">The waiting was cancelled, or the document changed before the computation was done.</exception>
    public Task<DerivedDocument> ForCurrentAsync(CancellationToken cancellation)
    {
        lock (_guard)
        {
            var state = _document.Current;
            var strategy = StrategyFor(state);
            if (IsOf(Current, state, strategy, _line)) return Task.FromResult(Current);
            if (_running is null || !IsOf(_running.Wanted, state, strategy, _line)) Start(new DerivedDocument(state, strategy) { Line = _line, Plate = _plates.Of(state) });
            return _running!.Result.WaitAsync(cancellation);
        }
    }

    /// <summary>Ends the search for the order in the running computation, which continues with the best order that was found.</summary>
    /// <returns>False if it does not search, or if the search was ended before.</returns>
    public bool StopOrderSearch()
    {
        lock (_guard) return _running is { } running && running.OrderStop.TryStop();
    }

    /// <summary>Cancels the running computation.</summary>
    /// <returns>False if there is none.</returns>
    public bool Cancel()
    {
        lock (_guard)
        {
            if (_running is null) return false;
            _running.Cancel.Cancel();
            (_cancelledWork, _running) = (_running.Wanted, null);
        }

        Progress.End();
        Changed?.Invoke(this, EventArgs.Empty);
        return true;
    }

    public void Dispose()
    {
        _document.Changed -= OnDocumentChanged;
        _plates.Changed -= OnDocumentChanged;
        lock (_guard) _running?.Cancel.Cancel();
    }

    private ExecutionStrategy StrategyFor(DocumentState state)
    {
        var driver = MachineFamilies.DriverOf(state.Settings.Machine);
        return _strategy is { } chosen && driver.Strategies.Contains(chosen) ? chosen : driver.DefaultStrategy;
    }

    private bool IsOf(DerivedDocument derived, DocumentState state, ExecutionStrategy strategy, SerialAddress? line) => derived.Line == line && IsOf(derived, state, strategy, _plates.Of(state));

    private static bool IsOf(DerivedDocument derived, DocumentState state, ExecutionStrategy strategy, Plate? plate) =>
        derived.Strategy == strategy && ReferenceEquals(derived.State.Drawing, state.Drawing) && derived.State.Settings == state.Settings && derived.Plate == plate;

    private void Start(DerivedDocument wanted)
    {
        _running?.Cancel.Cancel();
        _cancelledWork = null;
        var (cancel, orderStop) = (new CancellationTokenSource(), new OrderStop());
        var known = IsOf(Current, wanted.State, wanted.Strategy, wanted.Plate) ? Current : null;
        var before = known is null && Prerequisite?.Invoke(wanted.State) is { } wait ? wait.WaitAsync(cancel.Token) : Task.CompletedTask;
        var work = Task.Run(
            async () =>
            {
                await before.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
                return (known ?? DerivedDocument.Create(wanted.State, wanted.Strategy, cancel.Token, Progress.CreateReporter(cancel.Token), wanted.Plate, orderStop)).WithLine(wanted.Line);
            },
            cancel.Token);
        _running = new Derivation(wanted, cancel, orderStop, FinishAsync(work, cancel));
    }

    private async Task<DerivedDocument> FinishAsync(Task<DerivedDocument> work, CancellationTokenSource cancel)
    {
        var derived = await CatchFailureAsync(work, cancel).ConfigureAwait(ConfigureAwaitOptions.ForceYielding); // Never inside the caller's lock.
        lock (_guard)
        {
            cancel.Token.ThrowIfCancellationRequested();
            Current = derived;
            if (ReferenceEquals(_running?.Cancel, cancel)) _running = null;
        }

        Progress.End();

        Changed?.Invoke(this, EventArgs.Empty);
        return derived;
    }

    private async Task<DerivedDocument> CatchFailureAsync(Task<DerivedDocument> work, CancellationTokenSource cancel)
    {
        try
        {
            return await work.ConfigureAwait(false);
        }
        finally
        {
            if (work.IsFaulted && !cancel.IsCancellationRequested) Progress.End();
        }
    }

    private void OnDocumentChanged(object? sender, EventArgs e)
    {
        lock (_guard)
        {
            if (_running is not null && !IsOf(_running.Wanted, _document.Current, Strategy, _line))
            {
                _running.Cancel.Cancel();
                _running = null;
            }
        }

        if (_isAutomatic && !IsCancelled) _ = ForCurrentAsync(CancellationToken.None);
        else if (_running is null) Progress.End();
    }

    private sealed record Derivation(DerivedDocument Wanted, CancellationTokenSource Cancel, OrderStop OrderStop, Task<DerivedDocument> Result);
}
