namespace Engraver.Workbench.Histories;

/// <summary>A run that has begun and stands in the history as such until it ends, so that one whose program is killed is in the history too.</summary>
public sealed class OpenJob : IDisposable
{
    private readonly JobHistory _history;
    private readonly Action<string> _failed;
    private HistoryEntry? _begun;

    /// <param name="begun">How it stands in the history meanwhile.</param>
    /// <param name="failed">Told why the history could not be written, without a full stop.</param>
    public OpenJob(JobHistory history, HistoryEntry begun, Action<string> failed)
    {
        ArgumentNullException.ThrowIfNull(history);
        (_history, _failed) = (history, failed);
        (_begun, var failure) = history.Add(begun);
        Tell(failure);
    }

    /// <summary>The run ended; what is told of it takes the place of what was begun.</summary>
    public void End(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        if (_begun is not { } begun) throw new InvalidOperationException("A job ends once.");
        _begun = null;
        Tell(_history.Keep(entry with { Id = begun.Id }));
    }

    /// <summary>Without an end it was no run: nothing was done with a machine.</summary>
    public void Dispose()
    {
        if (_begun is not { } begun) return;
        _begun = null;
        Tell(_history.Drop(begun));
    }

    private void Tell(string? failure)
    {
        if (failure is not null) _failed(failure);
    }
}
