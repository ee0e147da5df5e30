namespace Engraver.App.Desk;

/// <summary>Runs tasks one after the other; a failure of one does not keep the next from running. For the UI thread, on which each of them begins.</summary>
/// <param name="first">The result before the first task.</param>
internal sealed class TaskChain<T>(T first)
{
    /// <summary>The task that was added last; completes when everything that was added has ended.</summary>
    public Task<T> Last { get; private set; } = Task.FromResult(first);

    public Task<T> Add(Func<Task<T>> work)
    {
        var added = AfterAsync(Last, work);
        Last = added;
        return added;
    }

    private static async Task<T> AfterAsync(Task before, Func<Task<T>> work)
    {
        await before.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
        return await work();
    }
}
