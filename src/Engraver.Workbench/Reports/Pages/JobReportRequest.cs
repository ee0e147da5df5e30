using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Reports.Pages;

/// <summary>Parameters of a job report.</summary>
public sealed record JobReportRequest(Drawing Drawing, DrawingSettings Settings, ExecutionStrategy Strategy, DateTimeOffset Now)
{
    /// <summary>The link of the job; null for a network.</summary>
    public ControllerAddress? Address { get; init; }

    /// <summary>The controller families that the profile of a run may name.</summary>
    public MachineFamilies Families { get; init; } = MachineFamilies.Standard;

    /// <summary>Machine rates; null for those of the profile.</summary>
    public JobRates? Rates { get; init; }

    /// <summary>The reported run.</summary>
    public HistoryEntry? Run { get; init; }

    /// <summary>Its journal, beside which the trace is saved.</summary>
    public string? Journal { get; init; }

    /// <summary>The plate, unless the journal has one; null for none.</summary>
    public Plate? Plate { get; init; }

    /// <summary>Names settings in findings for the front end (<see cref="SettingWording"/>).</summary>
    public Func<Diagnostic, Diagnostic> Spell { get; init; } = SettingWording.OnConsole;

    /// <summary>The same request for the run of <see cref="Journal"/>, or by default for the last run of the drawing in the history.</summary>
    public JobReportRequest WithRunOf(HistorySnapshot history)
    {
        ArgumentNullException.ThrowIfNull(history);
        var (drawing, journal) = (Path.GetFullPath(Drawing.FileName), Journal is null ? null : Path.GetFullPath(Journal));
        var run = history.Entries.FirstOrDefault(entry => entry.Drawing == drawing && (journal is null ? entry.Kind is "run" or "simulation" : entry.Journal == journal));
        var kept = run?.Journal is { } its && File.Exists(TraceFile.PathOf(its)) ? its : null;
        return this with { Run = run, Journal = Journal ?? kept };
    }
}
