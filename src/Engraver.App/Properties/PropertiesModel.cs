using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Tables;
using Engraver.App.Texts;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Commands.Properties;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Documents;

namespace Engraver.App.Properties;

/// <summary>The properties of the selection, which can be edited, and in a separate section the 16 slots of its rows by name.</summary>
public sealed class PropertiesModel : ObservableObject
{
    /// <summary>Maximum number of listed rows; more are only counted.</summary>
    private const int MaxRows = 20;

    /// <summary>Maximum number of selected objects for which the rows of the table are searched.</summary>
    private const int MaxObjects = 20;

    private readonly DesktopModel _desk;
    private (Drawing? Drawing, IReadOnlyList<int>? Selection, EntityTable? Table, DisplayPrecision Figures) _shown;

    public PropertiesModel(DesktopModel desk)
    {
        _desk = desk;
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public IReadOnlyList<PropertyLine> Lines { get; private set; } = [];

    public string Summary { get; private set; } = "";

    private void Refresh()
    {
        var state = _desk.Session.Document.Current;
        var derived = _desk.Derived.Current;
        var table = ReferenceEquals(derived.State.Drawing, state.Drawing) ? derived.Sequence?.Table : null; // the rows of an earlier drawing refer to other entities
        var now = (state.Drawing, state.Selection, table, _desk.Session.Settings.Current.Figures());
        if (now == _shown) return;
        _shown = now;
        Summary = state.Selection.Count == 0 ? Text.Get("Properties.Nothing") : Text.Get("Properties.Selected", state.Selection.Count);
        Lines = state.Drawing is { } drawing && state.Selection.Count > 0 ? LinesOf(drawing, table, state.Selection, now.Item4) : [];
        OnPropertyChanged(null);
    }

    private List<PropertyLine> LinesOf(Drawing drawing, EntityTable? table, IReadOnlyList<int> selection, DisplayPrecision figures)
    {
        var lines = new List<PropertyLine>();
        var values = ObjectProperties.Of(drawing, selection, figures);
        foreach (var section in values.GroupBy(value => value.Property.IsGeneral))
        {
            lines.Add(PropertyLine.Header(Text.Get(section.Key ? "Properties.General" : "Properties.Geometry")));
            lines.AddRange(section.Select(value => LineOf(value, drawing)));
        }

        if (table is not null && selection.Count <= MaxObjects) lines.AddRange(TableLines(table, selection));
        return lines;
    }

    private PropertyLine LineOf(PropertyValue value, Drawing drawing)
    {
        var of = _desk.Session.Document.Current;
        return new PropertyLine(value.Property.Title, value.Value, value.IsEditable ? typed => ChangeAsync(value, typed, of) : null) { Choices = value.IsEditable ? value.Property.Choices(drawing) : [] };
    }

    /// <summary>Runs CHPROP on the selection, as if typed. Not for a line that is no longer shown, and not during a command, because that would end the
    /// command and lose the selection.</summary>
    /// <returns>False if nothing was changed.</returns>
    private async Task<bool> ChangeAsync(PropertyValue value, string typed, DocumentState of)
    {
        var state = _desk.Session.Document.Current;
        if (typed.Length == 0 || !ReferenceEquals(state.Drawing, of.Drawing) || !ReferenceEquals(state.Selection, of.Selection)) return false;
        if (_desk.Prompt.Command is { } asking)
        {
            _desk.Notifications.Write(MessageKind.Warning, Text.Get("Properties.CommandAsks", value.Property.Title, asking));
            return false;
        }

        return await _desk.Queue.RunAsync("CHPROP", value.Property.Name, typed) is InputResult.Done;
    }

    private static IEnumerable<PropertyLine> TableLines(EntityTable table, IReadOnlyList<int> selection)
    {
        var chosen = selection.ToHashSet();
        int[] rows = [.. Enumerable.Range(0, table.Count).Where(row => chosen.Contains(table.EntityIndexOf(row))).Take(MaxRows + 1)];
        if (rows.Length == 0) yield break;
        yield return PropertyLine.Header(Text.Get("Properties.Table"));
        foreach (var row in rows.Take(MaxRows))
        {
            yield return PropertyLine.Header(Text.Get("Properties.Row", row + 1));
            for (var slot = 0; slot < EntitySlot.Count; slot++) yield return new PropertyLine($"{SlotNames.NameOf(slot)} {SlotNames.UnitOf(slot)}".TrimEnd(), new TableRow(table, row).Figure(slot), null);
        }

        if (rows.Length > MaxRows) yield return PropertyLine.Header(Text.Get("Properties.MoreRows"));
    }
}
