using Avalonia;
using Avalonia.Threading;

namespace Engraver.SoftwarePlatform.Headless;

/// <summary>Runs one Avalonia application on a thread of its own, for tests. Only one per process, because Avalonia can be set up only once.</summary>
public sealed class HeadlessRunner : IDisposable
{
    private readonly CancellationTokenSource _ending = new();
    private readonly TaskCompletionSource _ready = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly Thread _thread;
    private Dispatcher? _dispatcher;

    /// <param name="desktop">The one that <paramref name="configure"/> names as its front end.</param>
    /// <param name="configure">Called on the new thread: the builder, with <see cref="AppBuilderExtensions.UseSoftwarePlatform"/>, not yet set up.</param>
    public HeadlessRunner(HeadlessDesktop desktop, Func<AppBuilder> configure)
    {
        Desktop = desktop;
        _thread = new Thread(() => RunApplication(configure)) { IsBackground = true, Name = "Headless user interface" };
        _thread.Start();
        _ready.Task.GetAwaiter().GetResult();
    }

    public HeadlessDesktop Desktop { get; }

    private Dispatcher Ui => _dispatcher ?? throw new InvalidOperationException("The application is not set up.");

    /// <summary>Runs the action on the user interface thread and waits for it. Its exceptions are thrown here.</summary>
    public void Run(Action action) => Ui.Invoke(action);

    public T Run<T>(Func<T> action) => Ui.Invoke(action);

    public Task RunAsync(Func<Task> done, CancellationToken cancellation = default) => Ui.InvokeAsync(done).WaitAsync(cancellation);

    public Task<T> RunAsync<T>(Func<Task<T>> done, CancellationToken cancellation = default) => Ui.InvokeAsync(done).WaitAsync(cancellation);

    public void Dispose()
    {
        _ending.Cancel();
        _thread.Join();
        _ending.Dispose();
    }

    private void RunApplication(Func<AppBuilder> configure)
    {
        try
        {
            configure().SetupWithoutStarting();
            _dispatcher = Dispatcher.UIThread;
            Desktop.Step();
        }
        catch (Exception e) // any exception is passed to the caller that requested the application
        {
            _ready.SetException(e);
            return;
        }

        _ready.SetResult();
        Dispatcher.UIThread.MainLoop(_ending.Token);
    }
}
