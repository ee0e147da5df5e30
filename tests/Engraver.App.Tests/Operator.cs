using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Threading;
using Avalonia.VisualTree;
using Engraver.App.Desk;
using Engraver.App.Platforms;
using Engraver.App.Sessions;
using Engraver.App.Shell;
using Engraver.App.Tabs;
using Engraver.SoftwarePlatform.Headless;
using Engraver.TestKit;
using Engraver.Workbench.Commands;

namespace Engraver.App.Tests;

/// <summary>A simulated operator of the desktop: input, checks and waits. On the user interface thread.</summary>
internal sealed class Operator
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60);
    private readonly DesktopFixture _fixture;
    private readonly RunningClock? _runningClock;

    /// <param name="clock">By which machine and session go; one that a test moves passes while the operator waits or steps. Null is the wall's.</param>
    /// <param name="workFolder">The folder of the drawings; null is the samples.</param>
    public Operator(DesktopFixture fixture, string folder, TimeProvider? clock = null, string? workFolder = null)
    {
        _fixture = fixture;
        _runningClock = clock is ManualTimeProvider moved ? new RunningClock(moved) : null;
        Session = new DesktopSession(new CommandEnvironment { Time = clock ?? TimeProvider.System, Folder = workFolder ?? RepositoryFolder.Samples, SettingsFile = Path.Combine(folder, "desktop.json"), RunJournalFolder = folder }) { PlatformState = fixture.Regions };
        Window = ((App)Application.Current!).OpenShell(Session);
        Window.Opened += (_, _) => DesktopPlatform.WatchStop(Window, Session);
        Window.Show();
        Step();
        Hands = fixture.Desktop.Windows[^1];
    }

    public DesktopSession Session { get; }

    public DesktopModel Desk => Session.Desk;

    public CommandSession Commands => Desk.Session;

    public ShellWindow Window { get; }

    public HeadlessWindow Hands { get; }

    /// <summary>The lines of the history.</summary>
    public IEnumerable<string> History => Window.Model.Command.History.Select(line => line.Text);

    public void Step() => _fixture.Desktop.Step();

    /// <param name="patience">Null for a minute.</param>
    public void Until(Func<bool> condition, TimeSpan? patience = null)
    {
        try
        {
            _fixture.Desktop.StepUntil(condition, patience ?? s_patience);
        }
        catch (TimeoutException late)
        {
            throw new TimeoutException($"{late.Message} Busy: {Desk.Queue.IsBusy}, asked: {Commands.Prompt.Command}, machine: {Commands.Machine.Status.State}, idle: {Desk.Queue.Idle.Status}. The history ends with:\n{string.Join('\n', History.TakeLast(15))}", late);
        }
    }

    /// <summary>Types words with Enter after each, and waits until all are processed.</summary>
    public void Enter(params ReadOnlySpan<string> words)
    {
        foreach (var word in words)
        {
            Hands.Type(word);
            Hands.Press(Key.Enter);
            WaitUntilIdle();
        }
    }

    /// <summary>Waits until every input is processed and all results are shown.</summary>
    public void WaitUntilIdle()
    {
        Until(() => !Desk.Queue.IsBusy && Desk.Queue.Idle.IsCompleted && Window.Model.Files.IsIdle);
        var settled = Desk.SettleAsync();
        Until(() => settled.IsCompleted && Window.CanvasSource.Shown.IsCompleted);
        Step();
    }

    public void Open(string sample)
    {
        Enter("OPEN", sample);
        Until(() => Window.Canvas.Scene is not null);
    }

    public T Find<T>(string name)
        where T : Control => Window.GetVisualDescendants().OfType<T>().First(control => control.Name == name);

    public Point MiddleOf(Visual control) => control.TranslatePoint(new Point(control.Bounds.Width / 2, control.Bounds.Height / 2), Window)!.Value;

    public void Click(Visual control)
    {
        Hands.Click(MiddleOf(control));
        Step();
    }

    /// <summary>Brings a page or a palette to the front; a folded panel is opened.</summary>
    public void Show(string key)
    {
        var tabs = Window.GetVisualDescendants().OfType<PageTabs>().First(tabs => tabs.Pages.Any(page => page.Key == key));
        if (tabs.IsFolded) Click(tabs.GetVisualDescendants().OfType<Button>().First(button => button.Name == "FoldButton"));
        Click(tabs.GetVisualDescendants().OfType<ListBoxItem>().First(item => item.DataContext is PageTab tab && tab.Key == key));
        Step();
    }

    public void Leave()
    {
        Window.Close();
        if (Window.IsVisible && !Window.Model.Files.Question.IsOpen) Window.Close(); // a job runs: the second request closes
        if (Window.Model.Files.Question.IsOpen) Window.Model.Files.Question.Answers.Single(answer => answer.Name == "Files.DoNotSave").Choose.Execute(null);
        Step();
        var leaving = Session.DisposeAsync().AsTask();
        Until(() => leaving.IsCompleted);
        _runningClock?.Dispose();
    }
}

/// <summary>Advances the clock of a test at twice real time while the window's thread and the pool have time for it, so that the clock does not run ahead
/// of a program on a busy computer.</summary>
internal sealed class RunningClock : IDisposable
{
    private static readonly TimeSpan s_interval = TimeSpan.FromMilliseconds(5);

    /// <summary>Shorter than any wait of the program.</summary>
    private static readonly TimeSpan s_step = TimeSpan.FromMilliseconds(10);

    private readonly Timer _timer;
    private int _isPosted;

    public RunningClock(ManualTimeProvider clock) => _timer = new Timer(_ => Advance(clock), null, s_interval, s_interval);

    public void Dispose() => _timer.Dispose();

    private void Advance(ManualTimeProvider clock)
    {
        if (Interlocked.Exchange(ref _isPosted, 1) != 0) return;
        Dispatcher.UIThread.Post(() =>
        {
            Volatile.Write(ref _isPosted, 0);
            clock.Advance(s_step);
        });
    }
}
