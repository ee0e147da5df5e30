using Engraver.Core.Machines;

namespace Engraver.Workbench.Documents;

/// <summary>Computes what follows from the document (<see cref="DerivedDocument"/>) in the background, once for each state. The work is given up when the state changes before it is done.</summary>
/// <remarks>Any thread. Without <see cref="KeepsUp"/> nothing is computed until somebody asks.</remarks>
public sealed class DerivationSession : IDisposable
{
    private readonly Lock _guard = new();
    private readonly DocumentSession _document;
    private Work? _work;
    private JobMode _mode = JobMode.Stream;
    private SerialAddress? _line;
    private bool _keepsUp;

    public DerivationSession(DocumentSession document)
    {
        ArgumentNullException.ThrowIfNull(document);
        _document = document;
        _document.Changed += OnDocumentChanged;
    }

    /// <summary>Raised after <see cref="Current"/> has become another one, on a thread of the pool.</summary>
    public event EventHandler? Changed;

    /// <summary>The last one that was finished; it may lag behind the document.</summary>
    public DerivedDocument Current { get; private set; } = DerivedDocument.Nothing;

    /// <summary>True when <see cref="Current"/> is of the document as it stands.</summary>
    public bool IsCurrent => IsOf(Current, _document.Current, Mode, Line);

    /// <summary>The execution strategy that jobs are prepared for.</summary>
    public JobMode Mode
    {
        get => _mode;
        set
        {
            _mode = value;
            if (_keepsUp) _ = ForCurrentAsync(CancellationToken.None);
        }
    }

    /// <summary>The serial line that the machine is connected by; null for none. Another one makes another plan of the same job.</summary>
    public SerialAddress? Line
    {
        get => _line;
        set
        {
            if (_line == value) return;
            _line = value;
            if (_keepsUp) _ = ForCurrentAsync(CancellationToken.None);
        }
    }

    /// <summary>True: every new state is computed at once, as a desktop wants it.</summary>
    public bool KeepsUp
    {
        get => _keepsUp;
        set
        {
            _keepsUp = value;
            if (value) _ = ForCurrentAsync(CancellationToken.None);
        }
    }

    /// <summary>What follows from the document as it stands now. Never computes on the caller's thread.</summary>
    /// <param name="cancellation">Ends the waiting; the work goes on for others.</param>
    /// <exception cref="OperationCanceledException">The waiting was ended, or the document changed before the work was done.</exception>
    public Task<DerivedDocument> ForCurrentAsync(CancellationToken cancellation)
    {
        lock (_guard)
        {
            var state = _document.Current;
            if (IsOf(Current, state, _mode, _line)) return Task.FromResult(Current);
            if (_work is null || !IsOf(_work.Wanted, state, _mode, _line)) Begin(new DerivedDocument(state, _mode) { Line = _line });
            return _work!.Result.WaitAsync(cancellation);
        }
    }

    public void Dispose()
    {
        _document.Changed -= OnDocumentChanged;
        lock (_guard) _work?.Cancel.Cancel();
    }

    private static bool IsOf(DerivedDocument derived, DocumentState state, JobMode mode, SerialAddress? line) => derived.Line == line && IsOf(derived, state, mode);

    private static bool IsOf(DerivedDocument derived, DocumentState state, JobMode mode) =>
        derived.Mode == mode && ReferenceEquals(derived.State.Drawing, state.Drawing) && derived.State.Settings == state.Settings;

    private void Begin(DerivedDocument wanted)
    {
        _work?.Cancel.Cancel();
        var cancel = new CancellationTokenSource();
        var known = IsOf(Current, wanted.State, wanted.Mode) ? Current : null;
        var work = Task.Run(() => (known ?? DerivedDocument.Create(wanted.State, wanted.Mode, cancel.Token)).Over(wanted.Line), cancel.Token);
        _work = new Work(wanted, cancel, FinishAsync(work, cancel));
    }

    private async Task<DerivedDocument> FinishAsync(Task<DerivedDocument> work, CancellationTokenSource cancel)
    {
        var derived = await work.ConfigureAwait(ConfigureAwaitOptions.ForceYielding); // never inside the caller's lock
        lock (_guard)
        {
            cancel.Token.ThrowIfCancellationRequested();
            Current = derived;
            if (ReferenceEquals(_work?.Cancel, cancel)) _work = null;
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return derived;
    }

    private void OnDocumentChanged(object? sender, EventArgs e)
    {
        lock (_guard)
        {
            if (_work is not null && !IsOf(_work.Wanted, _document.Current, _mode, _line))
            {
                _work.Cancel.Cancel();
                _work = null;
            }
        }

        if (_keepsUp) _ = ForCurrentAsync(CancellationToken.None);
    }

    private sealed record Work(DerivedDocument Wanted, CancellationTokenSource Cancel, Task<DerivedDocument> Result);
}
