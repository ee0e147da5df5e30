namespace Engraver.Workbench.Histories;

/// <summary>A started run. Its entry is written at the start, so that a run whose process is killed is in the history too.</summary>
public sealed class PendingRun : IDisposable
{
    private readonly JobHistory _history;
    private readonly Action<string> _failed;
    private HistoryEntry? _begun;

    /// <param name="begun">The entry until the run ends.</param>
    /// <param name="failed">Receives why the history could not be written, without a full stop.</param>
    public PendingRun(JobHistory history, HistoryEntry begun, Action<string> failed)
    {
        ArgumentNullException.ThrowIfNull(history);
        (_history, _failed) = (history, failed);
        (_begun, var failure) = history.Add(begun);
        ReportFailure(failure);
    }

    /// <summary>Replaces the entry with the final one when the run has ended.</summary>
    public void End(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        if (_begun is not { } begun) throw new InvalidOperationException("A job ends once.");
        _begun = null;
        ReportFailure(_history.Save(entry with { Id = begun.Id }));
    }

    /// <summary>Without an end the entry is removed: no machine was used.</summary>
    public void Dispose()
    {
        if (_begun is not { } begun) return;
        _begun = null;
        ReportFailure(_history.Remove(begun));
    }

    private void ReportFailure(string? failure)
    {
        if (failure is not null) _failed(failure);
    }
}
