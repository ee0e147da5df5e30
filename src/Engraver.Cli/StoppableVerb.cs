namespace Engraver.Cli;

/// <summary>Runs a verb so that the operator's stop ends it soon, however long it computes.</summary>
/// <remarks>The stages change nothing but memory, so they need not end in order: the verb is left behind on its thread, which ends with the process. That
/// is as quick in the
/// middle of the longest loop, or of a read from a pipe without a writer, as between two stages, and no loop pays for it. Two things may not be left
/// behind. A machine:
/// while one is connected the verb is waited for, because it brakes first. And a file under its temporary name, which is deleted at the end of the process
/// (<see cref="Engraver.Workbench.Files.OutputFile"/>).</remarks>
internal static class StoppableVerb
{
    /// <summary>Computes something that the operator's stop need not wait for.</summary>
    /// <exception cref="OperationCanceledException">The operator stopped it; what computes is left behind.</exception>
    public static Task<T> ComputeAsync<T>(Func<T> compute, CancellationToken stop) => UntilStoppedAsync(OnItsOwnThread(() => Task.FromResult(compute())), stop);

    /// <returns>The exit code of the verb.</returns>
    /// <exception cref="OperationCanceledException">The operator stopped it. When the verb was left behind, <paramref name="streams"/> take nothing
    /// more.</exception>
    public static async Task<int> RunAsync(Func<Task<int>> verb, ConsoleStreams streams, MachineInHand machine, CancellationToken stop)
    {
        var running = OnItsOwnThread(verb);
        try
        {
            return await UntilStoppedAsync(running, stop).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            await Task.WhenAny(running, machine.LetGoAsync()).ConfigureAwait(false);
            if (running.IsCompleted) return await running.ConfigureAwait(false); // also when it ended in the same moment: how it ended is its own to say
            streams.Abandon();
            throw;
        }
    }

    /// <summary>As <see cref="Task{T}.WaitAsync(CancellationToken)"/>, which however goes on inside the thread that cancels, before anybody who registered
    /// earlier: there the machine has to be stopped first.</summary>
    private static async Task<T> UntilStoppedAsync<T>(Task<T> running, CancellationToken stop)
    {
        var stopped = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        await using var hearing = stop.UnsafeRegister(static heard => ((TaskCompletionSource)heard!).TrySetResult(), stopped).ConfigureAwait(false);
        await Task.WhenAny(running, stopped.Task).ConfigureAwait(false);
        return running.IsCompleted ? await running.ConfigureAwait(false) : throw new OperationCanceledException(stop);
    }

    /// <summary>Runs on a new thread, because a verb computes for long and the pool may be busy.</summary>
    private static Task<T> OnItsOwnThread<T>(Func<Task<T>> act) => Task.Factory.StartNew(act, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default).Unwrap();
}
