using System.Collections.Concurrent;
using System.Net;
using System.Net.Sockets;
using System.Text;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Sessions;
using Engraver.Links;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>The operator's stop while every thread of the thread pool is blocked: it is sent over the socket from the calling thread.</summary>
[Collection(nameof(BusyPool))]
public class BusyPoolTests
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(30);

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task The_stop_is_on_the_wire_while_no_thread_of_the_pool_is_free(JobMode mode)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 1.0 });
        using var served = new BlockingServer(controller);
        await using var session = await ControllerSession.OpenAsync(
            async cancellation => await TcpLink.ConnectAsync("127.0.0.1", served.Port, s_patience, TimeProvider.System, cancellation), new SessionOptions(), TimeProvider.System, CancellationToken.None);
        using var stop = new CancellationTokenSource();
        var cuts = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        var running = JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, SimulatedBench.Job with { Strategy = mode.Strategy() }, new CancelWhen(progress => progress.X > 4000, cuts.SetResult), stop.Token);
        await cuts.Task;
        var (wasFree, said) = (true, (string?)null);
        var operatorThread = new Thread(() =>
        {
            using var busy = new BusyPool();
            served.Lines.Clear();
            stop.Cancel();
            while (served.Lines.TryTake(out said, s_patience) && !said.StartsWith("CB", StringComparison.Ordinal))
            {
                // Sent by the job before.
            }

            wasFree = busy.WasFree;
        });
        operatorThread.Start();
        operatorThread.Join();
        var result = await running;

        Assert.Equal("CB 1;STS;ST AB;HX0", said);
        Assert.False(wasFree);
        Assert.Equal(JobOutcome.Stopped, result.Outcome);
    }

    /// <summary>Serves a simulated controller on separate threads, and records the lines received over the second connection.</summary>
    private sealed class BlockingServer : IDisposable
    {
        private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
        private readonly SimulatedController _controller;

        public BlockingServer(SimulatedController controller)
        {
            _controller = controller;
            _listener.Start();
            new Thread(Accept) { IsBackground = true }.Start();
        }

        public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

        /// <summary>The lines received over the handle of the stop.</summary>
        public StopLines Lines { get; } = new();

        public void Dispose() => _listener.Dispose();

        private void Accept()
        {
            try
            {
                for (var number = 0; ; number++)
                {
                    var (socket, isStop) = (_listener.AcceptSocket(), number > 0);
                    new Thread(() => Serve(socket, isStop)) { IsBackground = true }.Start();
                }
            }
            catch (SocketException)
            {
                // The listener was closed.
            }
        }

        private void Serve(Socket socket, bool isStop)
        {
            var bytes = new byte[4096];
            using var owned = socket;
            using var handle = _controller.OpenConnection();
            try
            {
                for (int count; (count = socket.Receive(bytes)) > 0;)
                {
                    if (isStop) Lines.Add(Encoding.Latin1.GetString(bytes, 0, count).TrimEnd('\r'));
                    handle.Write(bytes, 0, count);
                    socket.Send(bytes, handle.Read(bytes, 0, bytes.Length), SocketFlags.None);
                }
            }
            catch (SocketException)
            {
                // The host has disconnected.
            }
        }
    }

    private sealed class StopLines : BlockingCollection<string>
    {
        public void Clear()
        {
            while (TryTake(out _))
            {
                // Not part of the stop.
            }
        }
    }
}

/// <summary>Blocks every thread of the pool until it is disposed; queued work does not run.</summary>
internal sealed class BusyPool : IDisposable
{
    private const int Blockers = 256;
    private static readonly TimeSpan s_longest = TimeSpan.FromMilliseconds(500);
    private readonly ManualResetEventSlim _released = new();
    private readonly (int Workers, int Ports) _most;
    private readonly CountdownEvent _settled;
    private volatile bool _wasFree;

    public BusyPool()
    {
        ThreadPool.GetMaxThreads(out _most.Workers, out _most.Ports);
        ThreadPool.GetMinThreads(out var fewest, out _);
        Assert.True(ThreadPool.SetMaxThreads(fewest, _most.Ports));
        _settled = new CountdownEvent(fewest);
        for (var i = 0; i < Blockers; i++) ThreadPool.UnsafeQueueUserWorkItem(_ => Hold(), null);
        ThreadPool.UnsafeQueueUserWorkItem(_ => _wasFree = true, null);
        _settled.Wait(s_longest); // some threads may be delayed by others
    }

    /// <summary>Queued work has run.</summary>
    public bool WasFree => _wasFree;

    public void Dispose()
    {
        ThreadPool.SetMaxThreads(_most.Workers, _most.Ports);
        _released.Set();
    }

    private void Hold()
    {
        lock (_settled)
        {
            if (!_settled.IsSet) _settled.Signal();
        }

        _released.Wait();
    }
}

/// <summary>Tests that block the thread pool run alone.</summary>
[CollectionDefinition(nameof(BusyPool), DisableParallelization = true)]
public sealed class BusyPoolAlone;
