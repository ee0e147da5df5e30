using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Playback;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Plots;
using Engraver.Workbench.Settings;

namespace Engraver.App.Plots;

/// <summary>The page of plots: the planned motion, runs, and the values under the pointer.</summary>
public sealed class PlotsModel : ObservableObject, IVisibilityAware
{
    /// <summary>Maximum number of selected entities whose spans are marked.</summary>
    private const int MaxMarkedEntities = 50;

    private readonly DesktopModel _desk;
    private bool _isPageVisible;
    private (PlannedMotion? Motion, SerialAddress? Line, RecordedRun? Run, string? Compared, PlotAxis Axis, int Panels, bool IsReady) _shown;
    private (IReadOnlyList<int>? Selection, PlotContent? Content) _marked;
    private (string? Drawing, RecordedRun? Run)? _listed;
    private double? _pointed;

    /// <summary>The plan that is sampled in the background, and what cancels that; null for none.</summary>
    private (PlannedMotion Motion, Action Cancel)? _sampling;

    public PlotsModel(DesktopModel desk)
    {
        _desk = desk;
        Panels = [.. PlotPanel.All.Select(panel => new PlotToggle(panel, desk, this))];
        Export = new RelayCommand(() => _desk.Queue.RunAsync("PLOTEXPORT"), () => !IsEmpty);
        desk.Notifications.Changed += Refresh;
        desk.Derived.ToolMoved += RefreshPosition;
        Refresh();
    }

    public PlotContent Content { get; private set; } = PlotContent.Nothing;

    public bool IsEmpty => Content.Panels.Count == 0;

    /// <summary>There is nothing to plot.</summary>
    public bool HasNothing => IsEmpty && !IsSampling;

    /// <summary>Names and colours of the curves.</summary>
    public IReadOnlyList<PlotLegendEntry> Legend => PlotLegendEntry.Of(Content);

    /// <summary>One switch for each plot.</summary>
    public IReadOnlyList<PlotToggle> Panels { get; }

    public RelayCommand Export { get; }

    /// <summary>The stored runs of the drawing, the newest first, after an entry for none.</summary>
    public IReadOnlyList<StoredRunChoice> Runs { get; private set; } = [StoredRunChoice.None];

    /// <summary>The stored run for comparison.</summary>
    public StoredRunChoice Compared
    {
        get => Runs.FirstOrDefault(run => run.Journal == _desk.Session.Plots.ComparedJournal) ?? StoredRunChoice.None;
        set
        {
            if (value is not null && value.Journal != _desk.Session.Plots.ComparedJournal) _ = CompareAsync(value.Journal);
        }
    }

    /// <summary>The plots are over the path; otherwise over time.</summary>
    public bool IsOverPath
    {
        get => Settings.PlotAxis() == PlotAxis.Path;
        set
        {
            if (value == IsOverPath) return;
            _desk.Session.Settings.Change(settings => settings.WithPlotAxis(value ? PlotAxis.Path : PlotAxis.Time));
            Refresh();
        }
    }

    /// <summary>Height that all visible plots need, units of the window.</summary>
    public double MinHeight => Content.Panels.Count == 0 ? 0.0 : (Content.Panels.Count * PlotPicture.MinRowHeight) + PlotPicture.AxisHeight;

    /// <summary>Place of the playback on the common axis.</summary>
    public double Position => Reference?.Convert(PlotAxis.Time, _desk.Derived.AtSeconds, Content.Axis) ?? 0.0;

    /// <summary>Place under the pointer on the common axis; null for none.</summary>
    public double? Pointed
    {
        get => _pointed;
        set
        {
            if (SetProperty(ref _pointed, value)) OnPropertyChanged(nameof(Values));
        }
    }

    /// <summary>Time, path, entity and the values of all visible plots at the pointer; otherwise at the position of the playback.</summary>
    public string Values => IsEmpty ? "" : ValuesAt(_pointed ?? Position);

    /// <summary>Spans of the common axis in which the selected entities are cut.</summary>
    public IReadOnlyList<(double Start, double End)> Marks { get; private set; } = [];

    public bool IsPageVisible
    {
        get => _isPageVisible;
        set
        {
            if (SetProperty(ref _isPageVisible, value)) Refresh();
        }
    }

    /// <summary>A plan with more segments is sampled in the background.</summary>
    internal int MaxSegmentsAtOnce { get; set; } = 20_000;

    /// <summary>The sampling of a long plan in the background; completed when there is none.</summary>
    internal Task Sampled { get; private set; } = Task.CompletedTask;

    /// <summary>A long plan is sampled in the background.</summary>
    public bool IsSampling => _sampling is not null;

    /// <summary>The motion that converts between time and path: the plan, otherwise a run; null without any.</summary>
    private MotionSeries? Reference => Content.Plan ?? (Content.Series.Count > 0 ? Content.Series[0].Motion : null);

    private DesktopSettings Settings => _desk.Session.Settings.Current;

    /// <summary>Moves the playback to a place of the common axis.</summary>
    public void Seek(double place)
    {
        if (Content.Plan is not { } plan) return; // the playback is that of the plan
        _desk.Derived.MoveTo(plan.Convert(Content.Axis, place, PlotAxis.Time));
        _desk.Derived.RefreshToolPosition();
    }

    internal void Refresh()
    {
        if (!IsPageVisible)
        {
            Hide();
            return;
        }

        RefreshRuns();
        if (_desk.Derived.Current.Motion is { } motion && motion.SegmentCount > MaxSegmentsAtOnce && _desk.Session.Plots.IsPlanNew)
        {
            Sample(motion);
            return;
        }

        EndSampling();
        RefreshContent();
        RefreshMarks();
    }

    /// <summary>A hidden page keeps no plan and no samples.</summary>
    private void Hide()
    {
        EndSampling();
        _desk.Session.Plots.Forget();
        if (!IsEmpty) ShowNothing();
        _shown = default;
    }

    private void ShowNothing()
    {
        (Content, Marks, _shown, _marked) = (PlotContent.Nothing, [], default, default);
        OnPropertyChanged(null);
    }

    private void EndSampling()
    {
        _sampling?.Cancel();
        _sampling = null;
    }

    /// <summary>Selects a stored run by a command; if it fails, the list shows the previous choice again.</summary>
    private async Task CompareAsync(string? journal)
    {
        await (journal is null ? _desk.Queue.RunAsync("PLOTCOMPARE", "Off") : _desk.Queue.RunAsync("PLOTCOMPARE", "File", journal));
        OnPropertyChanged(nameof(Compared));
    }

    private void RefreshContent()
    {
        var (session, settings) = (_desk.Session, Settings);
        var now = (_desk.Derived.Current.Motion, _desk.Derived.Current.Line, session.Machine.Runs.Recorded, session.Plots.ComparedJournal, settings.PlotAxis(), settings.ChosenPlots().Sum(panel => panel.Mask), true);
        if (now == _shown) return;
        _shown = now;
        Content = session.Plots.Content(settings, CancellationToken.None);
        foreach (var toggle in Panels) toggle.Refresh();
        Export.RaiseCanExecuteChanged();
        OnPropertyChanged(null);
    }

    private void RefreshPosition()
    {
        if (IsEmpty) return;
        OnPropertyChanged(nameof(Position));
        if (_pointed is null) OnPropertyChanged(nameof(Values));
    }

    private void RefreshMarks()
    {
        var selection = _desk.Session.Document.Current.Selection;
        if (_marked == (selection, Content)) return;
        _marked = (selection, Content);
        var (plan, motion) = (Content.Plan, _desk.Derived.Current.Motion);
        Marks = plan is null || motion is null || selection.Count > MaxMarkedEntities
            ? []
            : [.. motion.TimesOf(selection).Select(span => (plan.Convert(PlotAxis.Time, span.Start, Content.Axis), plan.Convert(PlotAxis.Time, span.End, Content.Axis)))];
        OnPropertyChanged(nameof(Marks));
    }

    /// <summary>Samples a long plan in the background; the page is empty until then, because the curves of another plan would have another axis.</summary>
    private void Sample(PlannedMotion motion)
    {
        if (ReferenceEquals(_sampling?.Motion, motion)) return;
        EndSampling();
        var wanted = CancellationTokenSource.CreateLinkedTokenSource(_desk.Queue.Closing);
        var (plots, settings, token) = (_desk.Session.Plots, Settings, wanted.Token);
        _sampling = (motion, wanted.Cancel);
        ShowNothing();
        Sampled = ContinueAsync(Task.Run(() => plots.Content(settings, token), token));

        async Task ContinueAsync(Task sampled)
        {
            await sampled.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
            if (sampled.IsCompletedSuccessfully && ReferenceEquals(_sampling?.Motion, motion)) Refresh();
            wanted.Dispose();
        }
    }

    /// <summary>Lists the stored runs again after a run or for another drawing.</summary>
    private void RefreshRuns()
    {
        var now = (_desk.Session.Document.FilePath, _desk.IsMoving ? _listed?.Run : _desk.Session.Machine.Runs.Recorded);
        if (_listed == now) return;
        _listed = now;
        Runs = [StoredRunChoice.None, .. (now.FilePath is { } drawing ? TraceFile.AllOf(drawing, _desk.Session.RunJournalFolder) : []).Reverse().Select(journal => new StoredRunChoice(journal))];
        OnPropertyChanged(nameof(Runs));
        OnPropertyChanged(nameof(Compared));
    }

    private string ValuesAt(double place)
    {
        var (axis, plan) = (Content.Axis, Content.Plan);
        var motion = Reference!;
        var parts = new List<string>
        {
            Text.Get("PlotValue.Time", ClockText.Format(motion.Convert(axis, place, PlotAxis.Time), 2)),
            Text.Get("PlotValue.Path", motion.Convert(axis, place, PlotAxis.Path).ToString("0.##", CultureInfo.InvariantCulture)),
        };
        if (plan?.Entities?[plan.SampleAt(axis, place)] is { } entity and >= 0 && EntityName(entity) is { } name) parts.Add(name);
        foreach (var quantity in Content.Panels.SelectMany(panel => panel.Quantities))
        {
            var values = Content.Series.Select(series => (series, Value: series.Motion.ValueAt(quantity, axis, place))).Where(one => !double.IsNaN(one.Value)).ToList();
            if (values.Count == 0) continue;
            parts.Add(Text.Get("PlotValue." + quantity, string.Join(" / ", values.Select(one => Number(one.Value, quantity)))));
        }

        return string.Join("   ", parts);
    }

    private static string Number(double value, PlotQuantity quantity)
    {
        var decimals = quantity is PlotQuantity.Deviation or PlotQuantity.FollowingError ? 4 : 1;
        return (Math.Round(value, decimals) + 0.0).ToString(decimals == 1 ? "0.#" : "0.0000", CultureInfo.InvariantCulture); // adding zero removes the sign of a negative zero
    }

    /// <summary>Type and handle of an entity; null if the drawing has changed.</summary>
    private string? EntityName(int entity)
    {
        if (_desk.Derived.Current.State.Drawing is not { } document || ShownDrawing.Of(document) is not { } drawing || entity >= drawing.Entities.Count) return null;
        return Text.Get("PlotValue.Entity", drawing.Entities[entity].Type.ToDxfName(), drawing.SourceOf(entity).Handle ?? "");
    }
}
