using System.Globalization;
using Engraver.App.Texts;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports;

namespace Engraver.App.Histories;

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
