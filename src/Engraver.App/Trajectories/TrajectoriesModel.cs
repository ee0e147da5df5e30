using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Drawings;
using Engraver.Workbench.Sidecars;

namespace Engraver.App.Trajectories;

/// <summary>The trajectories of the document, each with its figures and editable values.</summary>
public sealed class TrajectoriesModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private (TrajectoryList? List, Drawing? Drawing) _shown;

    public TrajectoriesModel(DesktopModel desk)
    {
        _desk = desk;
        Export = new RelayCommand(() => _ = desk.Queue.RunAsync("SACEEXPORTTRAJECTORIES"));
        Update = new RelayCommand(() => _ = desk.Queue.RunAsync("SACEUPDATETRAJECTORIES"));
        DeleteAll = new RelayCommand(() => _ = desk.Queue.RunAsync("SACEDELETEALLTRAJECTORIES"));
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public IReadOnlyList<TrajectoryRow> Rows { get; private set; } = [];

    public bool IsEmpty => Rows.Count == 0;

    /// <summary>Their number, and how the next ones are created.</summary>
    public string Summary { get; private set; } = "";

    /// <summary>Objects of some trajectories were edited since these were created.</summary>
    public bool HasStale => Rows.Any(row => row.IsStale);

    public RelayCommand Export { get; }

    /// <summary>Recreates those whose objects were edited.</summary>
    public RelayCommand Update { get; }

    public RelayCommand DeleteAll { get; }

    private void Refresh()
    {
        var (list, drawing) = (_desk.Session.Document.Current.Sidecar.Trajectories, _desk.Session.Document.Current.Drawing);
        if (ReferenceEquals(list, _shown.List) && (ReferenceEquals(drawing, _shown.Drawing) || list.All.Count == 0)) return;
        var edits = drawing is not null && list.All.Count > 0 ? new TrajectoryEdits(drawing) : null;
        bool[] stale = [.. list.All.Select(one => edits?.IsStale(one) == true)];
        var isSame = ReferenceEquals(list, _shown.List) && stale.SequenceEqual(Rows.Select(row => row.IsStale));
        _shown = (list, drawing);
        if (isSame) return; // keeps the text that is being typed into a field
        Rows = [.. list.All.Select((one, index) => new TrajectoryRow(one, index, list.All.Count, _desk, UpdateStale) { IsStale = stale[index] })];
        Summary = Text.Get(list.Settings.DynamicDensity ? "Trajectories.Dynamic" : "Trajectories.Uniform", list.All.Sum(one => one.Curve.Points), list.Settings.DynamicDensity ? list.Settings.MaxErrorMm : list.Settings.SegmentLengthMm);
        OnPropertyChanged(null);
    }

    private void UpdateStale()
    {
        _shown = default;
        Refresh();
    }
}
