using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Diagnostics;

namespace Engraver.App.Findings;

/// <summary>The findings of CHECK, most severe first; a click shows the position.</summary>
public sealed class FindingsModel : Observable
{
    private readonly DesktopModel _desk;
    private IReadOnlyList<Diagnostic>? _shown;
    private FindingRow? _chosen;

    public FindingsModel(DesktopModel desk)
    {
        _desk = desk;
        desk.Notifications.Changed += Look;
        Look();
    }

    public IReadOnlyList<FindingRow> Rows { get; private set; } = [];

    public string Summary { get; private set; } = "";

    /// <summary>The clicked finding, which the canvas shows.</summary>
    public FindingRow? Chosen
    {
        get => _chosen;
        set
        {
            if (Set(ref _chosen, value) && value is not null) _desk.ShowPlaceOf(value.Diagnostic);
        }
    }

    private void Look()
    {
        var findings = _desk.Derived.Findings;
        if (ReferenceEquals(findings, _shown)) return;
        _shown = findings;
        if (_desk.Session.View.Current.Focus is { } pointed && !pointed.IsAmong(findings)) _desk.Session.View.PointNowhere();
        Rows = [.. findings.OrderByDescending(found => found.Severity).Select(found => new FindingRow(found))];
        Summary = Rows.Count == 0 ? Text.Get("Findings.None") : Text.Get("Findings.Summary", Text.Count("Count.Error", Rows.Count(row => row.IsError)), Text.Count("Count.Warning", Rows.Count(row => row.IsWarning)), Text.Count("Count.Finding", Rows.Count));
        Tell(nameof(Rows));
        Tell(nameof(Summary));
    }
}

/// <summary>A finding of CHECK.</summary>
public sealed class FindingRow(Diagnostic diagnostic)
{
    public Diagnostic Diagnostic => diagnostic;

    public string Severity => Text.Get("Severity." + diagnostic.Severity);

    public string Id => diagnostic.Id;

    public string Place => diagnostic.Source.Line == 0 ? "" : FormattableString.Invariant($"{diagnostic.Source.Line}");

    public string Handle => diagnostic.Source.Handle ?? "";

    public string Message => diagnostic.Message;

    public bool IsError => diagnostic.Severity == Core.Diagnostics.Severity.Error;

    public bool IsWarning => diagnostic.Severity == Core.Diagnostics.Severity.Warning;
}
