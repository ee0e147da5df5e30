using System.Collections.Concurrent;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>The thread that reads events, and the only one that uses the input connection. It waits in <c>poll</c> for the server and for work that other
/// threads post; it never waits for the user interface.</summary>
internal sealed unsafe class XEventThread
{
    private const int CloseOnExecNonBlocking = 0x80000 | 0x800;
    private readonly XConnection _connection;
    private readonly XEventHandler _handle;
    private readonly Action _lost;
    private readonly ConcurrentQueue<Action> _posted = new();
    private readonly Thread _thread;
    private readonly int _wake = Libc.eventfd(0, CloseOnExecNonBlocking);
    private int _lossReported;

    /// <param name="connection">Used by this thread only.</param>
    /// <param name="handle">Called for every event.</param>
    /// <param name="lost">Called once when the connection is lost.</param>
    public XEventThread(XConnection connection, XEventHandler handle, Action lost)
    {
        _connection = connection;
        _handle = handle;
        _lost = lost;
        _thread = new Thread(Run) { IsBackground = true, Name = "X11 input" };
    }

    public bool IsLost => Volatile.Read(ref _lossReported) != 0;

    public void Start() => _thread.Start();

    public void Post(Action work)
    {
        _posted.Enqueue(work);
        var one = 1L;
        Libc.write(_wake, &one, sizeof(long));
    }

    /// <summary>Runs a function on the thread and waits for it. Returns the default value when the connection is lost.</summary>
    public T? Invoke<T>(Func<T> work)
    {
        if (IsLost) return default;
        if (Thread.CurrentThread == _thread) return work();
        var done = new TaskCompletionSource<T?>(TaskCreationOptions.RunContinuationsAsynchronously);
        Post(() => done.TrySetResult(IsLost ? default : work()));
        return done.Task.GetAwaiter().GetResult();
    }

    /// <summary>May be called from any thread that notices the loss.</summary>
    public void ReportLoss()
    {
        if (Interlocked.Exchange(ref _lossReported, 1) == 0) _lost();
    }

    private void Run()
    {
        while (!IsLost)
        {
            DoPosted();
            ReadEvents();
            if (!IsLost) Wait();
        }

        while (true) // callers that still wait get an answer: see Invoke
        {
            DoPosted();
            Wait();
        }
    }

    private void DoPosted()
    {
        while (_posted.TryDequeue(out var work)) work();
    }

    private void ReadEvents()
    {
        while (!IsLost && Xlib.XPending(_connection.Display) > 0) // also sends pending requests
        {
            XEvent received;
            Xlib.XNextEvent(_connection.Display, &received);
            if (!IsLost) _handle(ref received);
        }
    }

    private void Wait()
    {
        var watched = stackalloc Libc.PollFd[2];
        watched[0] = new Libc.PollFd { Descriptor = _wake, Events = Libc.PollIn };
        watched[1] = new Libc.PollFd { Descriptor = Xlib.XConnectionNumber(_connection.Display), Events = Libc.PollIn };
        Libc.poll(watched, IsLost ? 1u : 2u, -1);
        if ((watched[1].ReturnedEvents & Libc.PollGone) != 0) ReportLoss();
        long count;
        if (watched[0].ReturnedEvents != 0) Libc.read(_wake, &count, sizeof(long));
    }
}
