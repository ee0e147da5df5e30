using Avalonia.Threading;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;

namespace Engraver.App.Playback;

/// <summary>The planned path over time: play, step, scrub. While it plays, a timer of the window updates the position.</summary>
public sealed class PlaybackModel : ObservableObject
{
    private const double FramesPerSecond = 60.0;
    private const double PagesPerPlan = 20.0;
    private readonly DesktopModel _desk;
    private readonly DispatcherTimer _timer;

    public PlaybackModel(DesktopModel desk)
    {
        _desk = desk;
        _timer = new DispatcherTimer(TimeSpan.FromSeconds(1.0 / FramesPerSecond), DispatcherPriority.Render, (_, _) => Tick());
        _timer.Stop();
        Speeds = [new(Text.Get("Playback.Slow"), 1.0, this), new(Text.Get("Playback.Fast"), 10.0, this), new(Text.Get("Playback.Max"), double.PositiveInfinity, this)];
        ToStart = new RelayCommand(() => At = 0.0);
        ToEnd = new RelayCommand(() => At = Total);
        StepBack = new RelayCommand(() => StepStroke(-1));
        StepForward = new RelayCommand(() => StepStroke(1));
        PlayOrPause = new RelayCommand(Toggle);
        desk.Notifications.Changed += Refresh;
        desk.Derived.ToolMoved += Refresh;
    }

    public IReadOnlyList<PlaybackSpeed> Speeds { get; }

    public RelayCommand ToStart { get; }

    public RelayCommand ToEnd { get; }

    /// <summary>To the start of the previous contour.</summary>
    public RelayCommand StepBack { get; }

    public RelayCommand StepForward { get; }

    public RelayCommand PlayOrPause { get; }

    public bool HasPlan => Total > 0.0;

    public bool IsPlaying => Session.IsPlaying;

    /// <summary>Seconds.</summary>
    public double Total => _desk.Derived.TotalSeconds;

    public double Page => Total / PagesPerPlan;

    /// <summary>Seconds; setting it moves the tool.</summary>
    public double At
    {
        get => _desk.Derived.AtSeconds;
        set
        {
            _desk.Derived.MoveTo(value);
            _desk.Derived.RefreshToolPosition();
        }
    }

    public string Time => Text.Get("Playback.Time", ClockText.Format(At), ClockText.Format(Total));

    public double Speed
    {
        get => Session.Speed;
        set
        {
            Session.Speed = value;
            foreach (var speed in Speeds) speed.Refresh();
        }
    }

    private Workbench.Playback.PlaybackSession Session => _desk.Session.Playback;

    private void Toggle()
    {
        if (Session.IsPlaying) Session.Pause();
        else Session.Play();
        Tick();
    }

    private void StepStroke(int by)
    {
        var stroke = _desk.Derived.StrokeUnderTool + by;
        if (stroke < 0) At = 0.0;
        else if (!Session.GoToStroke(stroke)) At = Total;
        _desk.Derived.RefreshToolPosition();
    }

    private void Tick()
    {
        _desk.Derived.RefreshToolPosition();
        Refresh();
    }

    private void Refresh()
    {
        if (_timer.IsEnabled != IsPlaying) _timer.IsEnabled = IsPlaying;
        OnPropertyChanged(null);
    }
}

/// <summary>A speed of the playback.</summary>
public sealed class PlaybackSpeed(string name, double factor, PlaybackModel playback) : ObservableObject
{
    public string Name => name;

    /// <summary>Multiple of the machine's own speed; infinite goes to the end immediately.</summary>
    public double Factor => factor;

    public bool IsChosen => playback.Speed == factor;

    public RelayCommand Choose { get; } = new(() => playback.Speed = factor);

    public void Refresh() => OnPropertyChanged(nameof(IsChosen));
}
