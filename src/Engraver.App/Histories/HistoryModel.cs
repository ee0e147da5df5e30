using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Workbench.Histories;

namespace Engraver.App.Histories;

/// <summary>The jobs that were run and the programs that were written, newest first, with actions on one of them.</summary>
public sealed class HistoryModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private HistorySnapshot? _shown;
    private string _search = "";
    private HistoryRow? _chosen;

    public HistoryModel(DesktopModel desk)
    {
        _desk = desk;
        Open = new RelayCommand(() => RunOption("Open"), () => _chosen is not null);
        Rerun = new RelayCommand(() => RunOption("Rerun"), () => _chosen is not null);
        Report = new RelayCommand(() => RunOption("rePort"), () => _chosen is not null);
        desk.Notifications.Changed += Refresh;
        Loaded = Task.Run(desk.Session.History.Refresh);
        Refresh();
    }

    /// <summary>Completes when the index has been read.</summary>
    public Task Loaded { get; }

    public IReadOnlyList<HistoryRow> Rows { get; private set; } = [];

    public bool IsEmpty => Rows.Count == 0;

    /// <summary>What could not be read of the index; empty for nothing.</summary>
    public string Findings { get; private set; } = "";

    public bool HasFindings => Findings.Length > 0;

    /// <summary>Only jobs that contain this text are shown.</summary>
    public string Search
    {
        get => _search;
        set
        {
            if (SetProperty(ref _search, value)) Show();
        }
    }

    public HistoryRow? Chosen
    {
        get => _chosen;
        set
        {
            if (!SetProperty(ref _chosen, value)) return;
            foreach (var command in (RelayCommand[])[Open, Rerun, Report]) command.RaiseCanExecuteChanged();
        }
    }

    /// <summary>Opens the drawing of the selected job in its present state, with the present settings.</summary>
    public RelayCommand Open { get; }

    /// <summary>Opens it with the settings that the job had.</summary>
    public RelayCommand Rerun { get; }

    /// <summary>Writes the report of the selected job.</summary>
    public RelayCommand Report { get; }

    private void RunOption(string option)
    {
        if (_chosen is { } row) _ = _desk.Queue.RunAsync("HISTORY", option, row.Entry.Id);
    }

    private void Refresh()
    {
        if (ReferenceEquals(_desk.Session.History.Snapshot, _shown)) return;
        Show();
    }

    private void Show()
    {
        _shown = _desk.Session.History.Snapshot;
        var kept = _chosen?.Entry.Id;
        Rows = [.. _shown.Filter(_search.Trim().Length == 0 ? null : _search.Trim()).Entries.Select(entry => new HistoryRow(entry, _desk.Time.LocalTimeZone))];
        Findings = string.Join('\n', _shown.Findings);
        OnPropertyChanged(null);
        Chosen = Rows.FirstOrDefault(row => row.Entry.Id == kept);
    }
}
