namespace Engraver.Workbench.Stages;

/// <summary>Ends the search for the order of one job early, so that the operator need not wait for its seconds. Any thread.</summary>
public sealed class OrderStop
{
    private readonly Lock _guard = new();
    private CancellationTokenSource? _search;

    /// <summary>Ends the search that is running; it keeps its best order, and the job continues with it. Later searches of the job end at once.</summary>
    /// <returns>False if no search for seconds is running, or if it was ended before.</returns>
    public bool TryStop()
    {
        lock (_guard)
        {
            if (_search is not { IsCancellationRequested: false } search) return false;
            search.Cancel();
            return true;
        }
    }

    /// <param name="search">Ends the searches that run from now on; null: none run.</param>
    internal void Watch(CancellationTokenSource? search)
    {
        lock (_guard) _search = search;
    }
}
