using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Diagnostics;

namespace Engraver.App.Findings;

/// <summary>The findings of CHECK, most severe first; a click shows the position.</summary>
public sealed class FindingsModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private IReadOnlyList<Diagnostic>? _shown;
    private FindingRow? _chosen;

    public FindingsModel(DesktopModel desk)
    {
        _desk = desk;
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public IReadOnlyList<FindingRow> Rows { get; private set; } = [];

    public string Summary { get; private set; } = "";

    /// <summary>The clicked finding, which the canvas shows.</summary>
    public FindingRow? Chosen
    {
        get => _chosen;
        set
        {
            if (SetProperty(ref _chosen, value) && value is not null) _desk.ShowPlaceOf(value.Diagnostic);
        }
    }

    private void Refresh()
    {
        var findings = _desk.Derived.Findings;
        if (ReferenceEquals(findings, _shown)) return;
        _shown = findings;
        if (_desk.Session.View.Current.Focus is { } pointed && !pointed.IsAmong(findings)) _desk.Session.View.ClearFocus();
        Rows = [.. findings.OrderByDescending(found => found.Severity).Select(found => new FindingRow(found))];
        Summary = Rows.Count == 0 ? Text.Get("Findings.None") : Text.Get("Findings.Summary", Text.Count("Count.Error", Rows.Count(row => row.IsError)), Text.Count("Count.Warning", Rows.Count(row => row.IsWarning)), Text.Count("Count.Finding", Rows.Count));
        OnPropertyChanged(nameof(Rows));
        OnPropertyChanged(nameof(Summary));
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
