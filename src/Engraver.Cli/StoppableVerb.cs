namespace Engraver.Cli;

/// <summary>Runs a verb so that the operator's stop ends it soon, however long it computes.</summary>
/// <remarks>The stages change only memory and need not be cancelled: the verb is abandoned on its thread, which ends with the process. This works in the middle
/// of a long loop or of a read from a pipe without a writer, and no loop has to check for cancellation. Two exceptions: while a machine is connected the
/// program waits for the verb, which stops the machine first; and temporary files are deleted when the process ends
/// (<see cref="Engraver.Workbench.Files.OutputFile"/>).</remarks>
internal static class StoppableVerb
{
    /// <summary>Runs a computation that is abandoned on the operator's stop.</summary>
    /// <exception cref="OperationCanceledException">The operator stopped it; the computation is abandoned.</exception>
    public static Task<T> ComputeAsync<T>(Func<T> compute, CancellationToken stop) => WaitUnlessStoppedAsync(RunOnNewThread(() => Task.FromResult(compute())), stop);

    /// <returns>The exit code of the verb.</returns>
    /// <exception cref="OperationCanceledException">The operator stopped it. If the verb was abandoned, <paramref name="streams"/> accept no more
    /// output.</exception>
    public static async Task<int> RunAsync(Func<Task<int>> verb, ConsoleStreams streams, ConnectionGuard machine, CancellationToken stop)
    {
        var running = RunOnNewThread(verb);
        try
        {
            return await WaitUnlessStoppedAsync(running, stop).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            await Task.WhenAny(running, machine.WaitForDisconnectAsync()).ConfigureAwait(false);
            if (running.IsCompleted) return await running.ConfigureAwait(false); // Also when it ended at the same moment: its own result counts.
            streams.Abandon();
            throw;
        }
    }

    /// <summary>Like <see cref="Task{T}.WaitAsync(CancellationToken)"/>, which however continues on the cancelling thread before callbacks registered earlier:
    /// those must stop the machine first.</summary>
    private static async Task<T> WaitUnlessStoppedAsync<T>(Task<T> running, CancellationToken stop)
    {
        var stopped = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        await using var hearing = stop.UnsafeRegister(static heard => ((TaskCompletionSource)heard!).TrySetResult(), stopped).ConfigureAwait(false);
        await Task.WhenAny(running, stopped.Task).ConfigureAwait(false);
        return running.IsCompleted ? await running.ConfigureAwait(false) : throw new OperationCanceledException(stop);
    }

    /// <summary>Runs on a new thread, because a verb may compute for a long time and the thread pool may be busy.</summary>
    private static Task<T> RunOnNewThread<T>(Func<Task<T>> verb) => Task.Factory.StartNew(verb, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default).Unwrap();
}
