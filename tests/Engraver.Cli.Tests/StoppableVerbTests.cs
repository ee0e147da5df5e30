namespace Engraver.Cli.Tests;

/// <summary>The operator's stop does not wait for a computing verb, but always for one with a connected machine.</summary>
public class StoppableVerbTests
{
    [Fact]
    public async Task A_verb_that_computes_is_left_behind_and_says_nothing_more()
    {
        using var verb = new LongVerb();
        using var said = new MemoryStream();
        using (var streams = new ConsoleStreams(said, TextWriter.Null))
        {
            var running = StoppableVerb.RunAsync(() => verb.Run(streams.Out), streams, new ConnectionGuard(), verb.Stop.Token);
            await verb.Begun;
            await verb.Stop.CancelAsync();

            await Assert.ThrowsAnyAsync<OperationCanceledException>(() => running);
        }

        Assert.Empty(said.ToArray());
    }

    [Fact]
    public async Task A_verb_with_a_machine_in_hand_is_waited_for_whatever_it_takes()
    {
        using var verb = new LongVerb();
        using var said = new MemoryStream();
        using (var streams = new ConsoleStreams(said, TextWriter.Null))
        {
            var machine = new ConnectionGuard();
            machine.SetConnected(true);
            var running = StoppableVerb.RunAsync(() => verb.Run(streams.Out), streams, machine, verb.Stop.Token);
            await verb.Begun;
            await verb.Stop.CancelAsync();
            Assert.False(running.IsCompleted);
            verb.Release();

            Assert.Equal(LongVerb.Code, await running);
        }

        Assert.Equal("half and whole", System.Text.Encoding.UTF8.GetString(said.ToArray()));
    }

    [Fact]
    public async Task A_machine_that_was_let_go_is_not_waited_for()
    {
        using var verb = new LongVerb();
        using var streams = new ConsoleStreams(Stream.Null, TextWriter.Null);
        var machine = new ConnectionGuard();
        machine.SetConnected(true);
        machine.SetConnected(false);
        var running = StoppableVerb.RunAsync(() => verb.Run(streams.Out), streams, machine, verb.Stop.Token);
        await verb.Begun;
        await verb.Stop.CancelAsync();

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => running);
    }

    [Fact]
    public async Task What_only_computes_is_left_behind_inside_a_verb_too()
    {
        using var verb = new LongVerb();
        var computing = StoppableVerb.ComputeAsync(() => verb.Run(TextWriter.Null), verb.Stop.Token);
        await verb.Begun;
        await verb.Stop.CancelAsync();

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => computing);
    }

    [Fact]
    public async Task A_machine_that_is_let_go_after_the_stop_is_waited_for_and_then_the_verb_is_left_behind()
    {
        using var verb = new LongVerb();
        using var streams = new ConsoleStreams(Stream.Null, TextWriter.Null);
        var machine = new ConnectionGuard();
        machine.SetConnected(true);
        var running = StoppableVerb.RunAsync(() => verb.Run(streams.Out), streams, machine, verb.Stop.Token);
        await verb.Begun;
        await verb.Stop.CancelAsync();
        Assert.False(running.IsCompleted);
        machine.SetConnected(false);

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => running);
    }

    [Fact]
    public async Task A_verb_that_ends_in_the_moment_of_the_stop_says_itself_how_it_ended()
    {
        using var streams = new ConsoleStreams(Stream.Null, TextWriter.Null);
        var machine = new ConnectionGuard();
        machine.SetConnected(true);
        for (var time = 0; time < 500; time++)
        {
            using var stop = new CancellationTokenSource();
            var ends = new TaskCompletionSource<int>(TaskCreationOptions.RunContinuationsAsynchronously);
            var running = StoppableVerb.RunAsync(() => ends.Task, streams, machine, stop.Token);
            await using var hears = stop.Token.Register(() => ends.SetResult(LongVerb.Code));
            await stop.CancelAsync();

            Assert.Equal(LongVerb.Code, await running);
        }
    }

    /// <summary>Token callbacks run in reverse order of registration, and the verb registered first: nothing that the program does at its end may delay the
    /// stop of the machine.</summary>
    [Fact]
    public async Task The_thread_of_the_signal_goes_on_to_the_machine_and_ends_no_program_before()
    {
        using var verb = new LongVerb();
        using var streams = new ConsoleStreams(Stream.Null, TextWriter.Null);
        var endedOn = 0;
        var running = StoppableVerb.RunAsync(() => verb.Run(streams.Out), streams, new ConnectionGuard(), verb.Stop.Token);
        var ended = running.ContinueWith(_ => endedOn = Environment.CurrentManagedThreadId, CancellationToken.None, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);
        await verb.Begun;
        var signal = new Thread(verb.Stop.Cancel);
        signal.Start();
        signal.Join();
        await ended;

        Assert.NotEqual(signal.ManagedThreadId, endedOn);
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => running);
    }

    /// <summary>A verb that ignores cancellation and computes until it is released.</summary>
    private sealed class LongVerb : IDisposable
    {
        public const int Code = 42;

        private readonly TaskCompletionSource _begun = new(TaskCreationOptions.RunContinuationsAsynchronously);
        private readonly ManualResetEventSlim _released = new();

        public CancellationTokenSource Stop { get; } = new();

        public Task Begun => _begun.Task;

        public Task<int> Run(TextWriter output)
        {
            output.Write("half");
            _begun.SetResult();
            _released.Wait();
            output.Write(" and whole");
            return Task.FromResult(Code);
        }

        public void Release() => _released.Set();

        /// <summary>Releases an abandoned verb; the event is not disposed, because the verb may still be waiting on it.</summary>
        public void Dispose()
        {
            Release();
            Stop.Dispose();
        }
    }
}
