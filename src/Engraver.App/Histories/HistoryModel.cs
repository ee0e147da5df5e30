using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports;

namespace Engraver.App.Histories;

/// <summary>The jobs that were run and the programs that were written, newest first, with actions on one of them.</summary>
public sealed class HistoryModel : Observable
{
    private readonly DesktopModel _desk;
    private HistoryReading? _shown;
    private string _search = "";
    private HistoryRow? _chosen;

    public HistoryModel(DesktopModel desk)
    {
        _desk = desk;
        Open = new Act(() => Do("Open"), () => _chosen is not null);
        Rerun = new Act(() => Do("Rerun"), () => _chosen is not null);
        Report = new Act(() => Do("rePort"), () => _chosen is not null);
        desk.Notifications.Changed += Look;
        Loaded = Task.Run(desk.Session.History.Look);
        Look();
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
            if (Set(ref _search, value)) Show();
        }
    }

    public HistoryRow? Chosen
    {
        get => _chosen;
        set
        {
            if (!Set(ref _chosen, value)) return;
            foreach (var act in (Act[])[Open, Rerun, Report]) act.Reconsider();
        }
    }

    /// <summary>Opens the drawing of the selected job in its present state, with the present settings.</summary>
    public Act Open { get; }

    /// <summary>Opens it with the settings that the job had.</summary>
    public Act Rerun { get; }

    /// <summary>Writes the report of the selected job.</summary>
    public Act Report { get; }

    private void Do(string option)
    {
        if (_chosen is { } row) _ = _desk.Queue.RunAsync("HISTORY", option, row.Entry.Id);
    }

    private void Look()
    {
        if (ReferenceEquals(_desk.Session.History.Known, _shown)) return;
        Show();
    }

    private void Show()
    {
        _shown = _desk.Session.History.Known;
        var kept = _chosen?.Entry.Id;
        Rows = [.. _shown.Holding(_search.Trim().Length == 0 ? null : _search.Trim()).Entries.Select(entry => new HistoryRow(entry, _desk.Time.LocalTimeZone))];
        Findings = string.Join('\n', _shown.Findings);
        Tell(null);
        Chosen = Rows.FirstOrDefault(row => row.Entry.Id == kept);
    }
}

/// <summary>A job.</summary>
public sealed class HistoryRow(HistoryEntry entry, TimeZoneInfo here)
{
    public HistoryEntry Entry => entry;

    public string Date => HistoryText.Date(entry, here);

    public string Drawing => Path.GetFileName(entry.Drawing);

    public string Kind => Text.Get("HistoryKind." + entry.Kind);

    public string Target => entry.Mode ?? entry.Target;

    public string Outcome => entry.Outcome;

    public bool IsBad => entry.Outcome is not ("complete" or "written");

    public string Seconds => entry.Seconds is { } seconds ? ClockText.Format(seconds) : "";

    /// <summary>Maximum deviation; that of a commanded path (no encoder feedback) is marked.</summary>
    public string Deviation => entry.MaxDeviation is not { } deviation ? "" : entry.OpenLoop is null ? deviation.ToString("0.0000", CultureInfo.InvariantCulture) : Text.Get("History.Commanded", deviation);

    /// <summary>The outcome, what the deviation refers to, and the location of the files.</summary>
    public string Tip => string.Join('\n', new[] { entry.Sentence, HistoryText.OpenLoop(entry), entry.Drawing, entry.Address, entry.Program, entry.Journal, entry.Report }.Where(line => !string.IsNullOrEmpty(line)));
}
