using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Properties;
using Engraver.App.Texts;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Reports;

namespace Engraver.App.Jobs;

/// <summary>The job before it starts: its checklist, its planned time, its start position.</summary>
public sealed class JobModel : ObservableObject
{
    private readonly DesktopModel _desk;

    public JobModel(DesktopModel desk)
    {
        _desk = desk;
        Check = new RelayCommand(() => _ = desk.Queue.RunAsync("CHECK"));
        Simulate = new RelayCommand(() => _ = desk.Queue.RunAsync("CNCSIM"));
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public RelayCommand Check { get; }

    public RelayCommand Simulate { get; }

    public IReadOnlyList<CheckLine> Checks { get; private set; } = [];

    public IReadOnlyList<PropertyLine> Figures { get; private set; } = [];

    public bool HasJob => _desk.Derived.Job is not null;

    private void Refresh()
    {
        var (checks, figures) = (ChecksNow(), FiguresNow());
        if (checks.SequenceEqual(Checks) && figures.SequenceEqual(Figures)) return;
        (Checks, Figures) = (checks, figures);
        OnPropertyChanged(null);
    }

    /// <summary>Warnings are for the next start: while a job runs, the machine is away from its start position as expected.</summary>
    private IReadOnlyList<CheckLine> ChecksNow() => _desk.Derived.Job is { } job
        ? [.. ArmingChecklist.Create(job, _desk.Session.Machine.Status, errorsAccepted: false, job.Motion.Program is { } program ? _desk.Session.Machine.Origins.LastPlacement(program, dryRun: _desk.Session.Machine.Arming.Armed is { DryRun: true }) : null, _desk.Time.GetUtcNow(), _desk.Session.Certificates.StatusOf(job)?.Check).Checks.Where(check => !check.IsWarning || !_desk.IsMoving).Select(check => new CheckLine(check))]
        : [];

    private List<PropertyLine> FiguresNow()
    {
        var settings = _desk.Session.Document.Current.Settings;
        var figures = new List<PropertyLine>
        {
            new(Text.Get("Job.Start"), string.Create(CultureInfo.InvariantCulture, $"{settings.Start.X:0.###}, {settings.Start.Y:0.###}")),
            new(Text.Get("Job.Order"), Text.Get("StrokeOrder." + settings.Order)),
        };
        if (settings.Operations is null) figures.Add(new(Text.Get("Job.Feed"), Text.Get("Job.MillimetresPerMinute", settings.Machine.FeedMmPerMinute))); // each operation has its own
        figures.Add(new(Text.Get("Job.Rapid"), Text.Get("Job.MillimetresPerMinute", settings.Machine.RapidMmPerMinute)));
        if (_desk.Derived.Sequence is { } sequence)
        {
            figures.Add(new(Text.Get("Job.Contours"), Text.Get("Job.ContourCount", sequence.Contours, sequence.Closed, sequence.Open)));
            figures.Add(new(Text.Get("Job.Segments"), sequence.Segments.ToString(CultureInfo.InvariantCulture)));
            figures.Add(new(Text.Get("Job.CutLength"), Text.Get("Job.Millimetres", sequence.PathLength)));
            figures.Add(new(Text.Get("Job.Travel"), Text.Get("Job.Millimetres", sequence.Travel)));
        }

        if (_desk.Derived.Current is { Job: { } job, Plan: { } plan } && JobSheet.Of(job, plan, settings.Machine.Rates).Cost is { } cost) figures.Add(new(Text.Get("Job.Cost"), Text.Get("Job.CostParts", cost.Total, cost.Time, cost.Length, cost.Starts)));
        if (_desk.Derived.Job?.Plate is { } plate) figures.Insert(0, new(Text.Get("Job.Plate"), _desk.Session.Plates.TextOf(plate)));
        if (_desk.Derived.PlannedSeconds is > 0.0 and var seconds) figures.Insert(0, new(Text.Get("Job.Time"), ClockText.Format(seconds)));
        return figures;
    }
}

/// <summary>A condition that must be met before a job may start, or a warning that the operator must have read.</summary>
public sealed record CheckLine(ArmingCheck Check)
{
    /// <summary>A shape in addition to the colour.</summary>
    public string Mark => Check switch { { IsNote: true } => "–", { IsCurrent: false } => "?", { Passed: false } => "✗", { IsWarning: true } => "▲", _ => "✓" };

    /// <summary>The sentence of the check; a warning is marked by a word, too.</summary>
    public string Sentence => Check.IsWarning ? Text.Get("Job.Warning", Check.Message) : Check.Message;

    /// <summary>True if the check has not passed, or is a warning.</summary>
    public bool IsUnusual => !Check.Passed || Check.IsWarning;
}
