using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Canvas.Colours;
using Engraver.App.Desk;
using Engraver.App.Properties;
using Engraver.App.Texts;
using Engraver.Core.Operations;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.App.Operations;

/// <summary>The operations of the document in their order, and the fields of the selected one.</summary>
public sealed class OperationsModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private (OperationPlan? Plan, PreparedJob? Job, DesktopTheme Theme, int Tool) _shown;
    private string? _selected;

    public OperationsModel(DesktopModel desk)
    {
        _desk = desk;
        Load = new RelayCommand(() => _ = desk.Queue.RunAsync("OPERATION", "LOad"));
        Add = new RelayCommand(() => _ = desk.Queue.RunAsync("OPERATION", "New"));
        Save = new RelayCommand(() => _ = desk.Queue.RunAsync("OPERATION", "Save"));
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public IReadOnlyList<OperationRow> Rows { get; private set; } = [];

    public bool IsEmpty => Rows.Count == 0;

    /// <summary>What of the drawing no operation takes.</summary>
    public string Summary { get; private set; } = "";

    /// <summary>The summary needs attention.</summary>
    public bool IsIncomplete { get; private set; }

    /// <summary>The fields of the selected operation; one that is typed runs OPERATION <c>Edit</c>.</summary>
    public IReadOnlyList<PropertyLine> Fields { get; private set; } = [];

    /// <summary>The tools of the operations; the first entry is every tool.</summary>
    public IReadOnlyList<string> Tools { get; private set; } = [];

    public RelayCommand Load { get; }

    public RelayCommand Add { get; }

    public RelayCommand Save { get; }

    /// <summary>Index into <see cref="Rows"/>; -1 for none.</summary>
    public int Selected
    {
        get => Rows.ToList().FindIndex(row => row.Operation.Id == _selected);
        set
        {
            var id = value >= 0 && value < Rows.Count ? Rows[value].Operation.Id : null;
            if (id is null || id == _selected) return; // the list is recreated
            _selected = id;
            ShowFields();
            OnPropertyChanged(nameof(Fields));
        }
    }

    /// <summary>Index into <see cref="Tools"/> of the tool of the job.</summary>
    public int Tool
    {
        get => _shown.Plan is { } plan && _shown.Tool > 0 ? 1 + NumbersOf(plan).IndexOf(_shown.Tool) : 0;
        set
        {
            if (_shown.Plan is not { } plan || value < 0 || value == Tool) return;
            _ = _desk.Queue.RunAsync("OPERATION", "Tool", (value == 0 ? 0 : NumbersOf(plan)[value - 1]).ToString(CultureInfo.InvariantCulture));
        }
    }

    private static List<int> NumbersOf(OperationPlan plan) => [.. plan.Operations.Select(operation => operation.Tool).Distinct().Order()];

    private void Refresh()
    {
        var settings = _desk.Session.Document.Current.Settings;
        var job = _desk.Derived.Job is { } prepared && Equals(prepared.Settings.Operations, settings.Operations) ? prepared : null;
        var now = (settings.Operations, job, _desk.Session.View.Current.Theme, settings.Tool);
        if (now == _shown) return;
        var isSamePlan = Equals(now.Operations, _shown.Plan);
        _shown = now;
        Show(settings.Operations, job, now.Theme);
        if (!isSamePlan) ShowFields(); // keeps the text that is being typed into a field
        OnPropertyChanged(null);
        OnPropertyChanged(nameof(Selected)); // the list resets its selection with its rows
        OnPropertyChanged(nameof(Tool));
    }

    private void Show(OperationPlan? plan, PreparedJob? job, DesktopTheme theme)
    {
        var colours = CanvasTheme.Of(theme).Operations;
        var summaries = job is null ? [] : OperationSummary.Of(job);
        Rows = plan is null ? [] : [.. plan.Operations.Select((operation, place) => new OperationRow(plan, operation, summaries.FirstOrDefault(one => one.Operation.Id == operation.Id), colours[CanvasTheme.OperationColour(place)], _desk))];
        if (Selected < 0) _selected = plan?.Operations[0].Id;
        Tools = plan is null ? [] : [Text.Get("Operations.AllTools"), .. NumbersOf(plan).Select(number => plan.Tools.First(tool => tool.Number == number).Title)];
        IsIncomplete = job is { NotTaken.Count: > 0 };
        Summary = job is null ? "" : job.NotTaken.Count == 0 ? Text.Get("Operations.Complete") : Text.Get("Operations.NotTaken", Text.Count("Count.Curve", job.NotTaken.Count));
    }

    private void ShowFields() => Fields = _shown.Plan is { } plan && plan.Operations.FirstOrDefault(one => one.Id == _selected) is { } operation ? [.. OperationEdits.FieldsOf(plan, operation).Select(field => LineOf(operation, field))] : [];

    private PropertyLine LineOf(Operation operation, OperationField field) =>
        new(Text.Get("OperationField." + field.Name), field.Value, async typed => await _desk.Queue.RunAsync("OPERATION", "Edit", operation.Id, field.Name, typed) is InputResult.Done) { Choices = field.Choices };
}
